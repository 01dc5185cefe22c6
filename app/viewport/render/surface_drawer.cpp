// app/viewport/render/surface_drawer.cpp: the smoothed surface on the graphics card.
#include "app/viewport/render/surface_drawer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include <glm/gtc/matrix_access.hpp>

#include "app/viewport/render/color_scales.h"
#include "app/viewport/render/occlusion.h"
#include "app/viewport/render/shape_mesh.h"
#include "core/geometry/parallel.h"

namespace sinew::app {

namespace {

constexpr std::array<const char*, 4> kShadingDefines{"SHADING_TEXTURED", "SHADING_CLAY", "SHADING_CLASSES",
                                                     "SHADING_HEAT"};

Result<GlProgram> loadSurface(const SurfaceKind& kind) {
  std::vector<const char*> files{"shaders/surface.vert", "shaders/surface.frag"};
  if (kind.wired) files.insert(files.begin() + 1, "shaders/surface_wire.geom");
  std::vector<const char*> define{kShadingDefines[static_cast<std::size_t>(kind.shading)]};
  const auto add = [&](bool is, const char* name) {
    if (is) define.push_back(name);
  };
  add(kind.wired, "WIRE");
  add(kind.marked, "MARKED");
  add(kind.colored, "COLORED");
  add(kind.chosen, "CHOSEN_LOOK");
  add((kind.maps & kNormalBit) != 0, "NORMAL_MAP");
  add((kind.maps & kRoughnessBit) != 0, "ROUGHNESS_MAP");
  add((kind.maps & kOcclusionBit) != 0, "OCCLUSION_MAP");
  add((kind.maps & kEmissiveBit) != 0, "EMISSIVE_MAP");
  add((kind.maps & kSharedBit) != 0, "SHARED_MAP");
  return GlProgram::load(files, define);
}

}  // namespace

Result<SurfacePrograms> SurfacePrograms::create() {
  SurfacePrograms programs;
  for (const Shading shading : {Shading::kTextured, Shading::kClay, Shading::kClasses, Shading::kHeat}) {
    for (unsigned bits = 0; bits < 8; ++bits) {
      const SurfaceKind kind{
          .shading = shading, .wired = (bits & 1) != 0, .marked = (bits & 2) != 0, .colored = (bits & 4) != 0};
      if (kind.colored && shading != Shading::kTextured) continue;
      Result<GlProgram> made = loadSurface(kind);
      if (!made) return made.error();
      programs.made_[kind] = std::move(made).value();
    }
  }
  return programs;
}

const GlProgram& SurfacePrograms::of(const SurfaceKind& kind) const {
  const auto [found, isNew] = made_.try_emplace(kind);
  if (isNew) {
    // The files loaded before; the usual picture is better than none.
    if (Result<GlProgram> made = loadSurface(kind)) found->second = std::move(made).value();
  }
  if (found->second.id() != 0) return found->second;
  SurfaceKind usual = kind;
  if (usual.maps != 0) usual.maps = 0;
  else usual.chosen = false;
  return of(usual);
}

namespace {

constexpr std::size_t kMostMarks = 4;  ///< As in shaders/surface.frag.
constexpr float kTerritoryStrength = 0.62f;
constexpr std::size_t kFewVertices = 8192;  ///< For one thread.

std::uint8_t byteOf(float value) {
  return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
}

/// Muscles whose reach is outlined on the skin: selected ones, then hovered ones.
std::vector<const PrimitiveShape*> markedShapes(const Frame& frame) {
  std::vector<const PrimitiveShape*> marked;
  for (const bool selected : {true, false}) {
    for (const PrimitiveShape& shape : frame.scene.primitives) {
      if (marked.size() == kMostMarks) return marked;
      if (selected ? shape.selected : (shape.hovered && !shape.selected)) marked.push_back(&shape);
    }
  }
  std::erase_if(marked, [](const PrimitiveShape* shape) {
    return !(std::abs(glm::determinant(glm::mat3(shape->unitBallInWorld))) > 0.0f);
  });
  return marked;
}

void setMarks(const GlProgram& program, const Frame& frame, std::span<const PrimitiveShape* const> shapes) {
  std::array<glm::vec4, 3 * kMostMarks> rows{};
  std::array<glm::vec4, std::tuple_size_v<FormVectors> * kMostMarks> forms{};
  std::array<glm::vec4, kMostMarks> reaches{}, colors{};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const PrimitiveShape& shape = *shapes[i];
    const ShapeInstance influence = shellOf(shape, shape.reach);
    const glm::mat4 inShell = glm::inverse(influence.shapeInWorld);
    for (glm::length_t row = 0; row < 3; ++row) rows[3 * i + static_cast<std::size_t>(row)] = glm::row(inShell, row);
    reaches[i] = glm::vec4(influence.style.w);
    std::ranges::copy(influence.form, forms.begin() + static_cast<std::ptrdiff_t>(i * influence.form.size()));
    colors[i] = glm::vec4(shapeColor(shape), shape.selected ? 0.62f : 0.30f);
  }
  program.set("markCount", static_cast<int>(shapes.size()));
  program.set("markRows", std::span<const glm::vec4>(rows));
  program.set("markForms", std::span<const glm::vec4>(forms));
  program.set("markReaches", std::span<const glm::vec4>(reaches));
  program.set("markColors", std::span<const glm::vec4>(colors));
  const float tint = frame.settings.territory ? kTerritoryStrength : 0.0f;
  program.set("territoryTint", glm::vec4(toLinear(kTerritoryColor), tint));
}

}  // namespace

SurfaceDrawer::SurfaceDrawer()
    : partSeen_(makeQuery(GL_ANY_SAMPLES_PASSED)),
      array_(makeVertexArray()),
      vertices_(makeBuffer()),
      besideVertices_(makeBuffer()),
      uvs_(makeBuffer()),
      skinValues_(makeBuffer()),
      colors_(makeBuffer()),
      indices_(makeBuffer()),
      seenIndices_(makeBuffer()),
      shadowIndices_(makeBuffer()),
      controlOf_(makeBuffer()),
      classes_(makeBuffer()),
      parts_(makeBuffer()) {
  const GLuint array = array_.id();
  glVertexArrayVertexBuffer(array, 0, vertices_.id(), 0, sizeof(Vertex));
  glVertexArrayVertexBuffer(array, 1, uvs_.id(), 0, sizeof(glm::vec2));
  glVertexArrayElementBuffer(array, indices_.id());
  setAttribute(array, 0, 0, 3, offsetof(Vertex, position));
  setAttribute(array, 1, 0, 3, offsetof(Vertex, normal));
  setAttribute(array, 2, 0, 1, offsetof(Vertex, displacement));
  setAttribute(array, 3, 1, 2, 0);
  glVertexArrayVertexBuffer(array, 2, skinValues_.id(), 0, sizeof(SkinValues));
  glEnableVertexArrayAttrib(array, 4);
  glVertexArrayAttribFormat(array, 4, 2, GL_UNSIGNED_BYTE, GL_TRUE, 0);
  glVertexArrayAttribBinding(array, 4, 2);
  glVertexArrayVertexBuffer(array, 3, colors_.id(), 0, sizeof(glm::vec4));
  setAttribute(array, 5, 3, 4, 0);
}

Result<SurfaceDrawer> SurfaceDrawer::create() {
  Result<SurfacePrograms> programs = SurfacePrograms::create();
  if (!programs) return programs.error();
  Result<GlProgram> part = GlProgram::load({"shaders/depth.vert", "shaders/part.frag"});
  if (!part) return part.error();
  SurfaceDrawer drawer;
  drawer.partProgram_ = std::move(part).value();
  drawer.programs_ = std::move(programs).value();
  return drawer;
}

void SurfaceDrawer::setCharacter(const Character& character) {
  refinement_.reset();
  ranges_.clear();
  bounds_ = {};
  materials_ = character.materials;
  materialOfPart_.clear();
  for (const MeshPart& part : character.parts) materialOfPart_.push_back(part.material);
  std::vector<int> parts;
  for (const ControlTriangle& triangle : character.mesh.triangles) parts.push_back(triangle.part);
  uploadBuffer(parts_, std::span<const int>(parts), GL_STATIC_DRAW);
  open_ = bakeOpenness(character.mesh);
  if (isSoftwareRenderer()) shadowClusters_ = shadowClusters(character);
  territory_.clear();
  revision_ = 0;
  textures_.set(character);
}

void SurfaceDrawer::rebuildSkinValues(const ControlMesh& mesh) {
  const std::vector<float> open = spreadOverRefinement(open_, mesh, *refinement_);
  const std::vector<float> own =
      territory_.empty() ? std::vector<float>{} : spreadOverRefinement(territory_, mesh, *refinement_);
  std::vector<SkinValues> values(refinement_->drawVertex.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(refinement_->drawVertex[i]);
    values[i] = {byteOf(open[vertex]), own.empty() ? std::uint8_t{0} : byteOf(own[vertex]), {}};
  }
  uploadBuffer(skinValues_, std::span<const SkinValues>(values), GL_STATIC_DRAW);
}

void SurfaceDrawer::stage(const Surface& surface) {
  const std::vector<int>& drawVertex = refinement_->drawVertex;
  staging_.resize(drawVertex.size());
  const bool displaced = surface.displacement.size() == surface.positions.size();
  forEachIndex(staging_.size(), kFewVertices, [&](std::size_t i) {
    const auto vertex = static_cast<std::size_t>(drawVertex[i]);
    staging_[i] = {surface.positions[vertex], shadingNormal(surface, i),
                   displaced ? surface.displacement[vertex] : 0.0f};
  });
}

void SurfaceDrawer::fillVertices(const Scene& scene) {
  stage(*scene.surface);
  uploadBuffer(vertices_, std::span<const Vertex>(staging_));
  glVertexArrayVertexBuffer(array_.id(), 0, vertices_.id(), 0, sizeof(Vertex));
  bounds_ = boundsOf(scene.surface->positions);
  hasBeside_ = scene.beside != nullptr;
  if (hasBeside_) {
    assert(scene.beside->refinement == refinement_);
    stage(*scene.beside);
    uploadBuffer(besideVertices_, std::span<const Vertex>(staging_));
    for (const glm::vec3& point : scene.beside->positions) bounds_.add(point);
  }
}

void SurfaceDrawer::takeCardVertices() {
  glVertexArrayVertexBuffer(array_.id(), 0, cardVertices_->buffer, 0, sizeof(Vertex));
  hasBeside_ = false;
  bounds_ = cardVertices_->bounds;
}

void SurfaceDrawer::fillClasses(const Scene& scene) {
  const std::vector<TriangleClass>& found = scene.surface->classes;
  const std::vector<ControlTriangle>& triangles = scene.character->mesh.triangles;
  std::vector<std::uint32_t> classes(refinement_->triangleBegin.size(), 0);
  for (std::size_t t = 0; t < found.size(); ++t) {
    const SkinLayer layer =
        scene.layers.empty() ? SkinLayer::kSkin : scene.layers[static_cast<std::size_t>(triangles[t].part)];
    const int level = refinement_->isUniform ? 0 : levelShown(*refinement_, static_cast<int>(t));
    classes[t] = static_cast<std::uint32_t>(zoneOf(found[t], layer)) + 8 * static_cast<std::uint32_t>(level);
  }
  uploadBuffer(classes_, std::span<const std::uint32_t>(classes));
}

void SurfaceDrawer::upload(const Scene& scene, bool showsClasses) {
  const Surface& surface = *scene.surface;
  const ControlMesh& mesh = scene.character->mesh;
  const std::vector<float>& territory = scene.territory;
  assert(open_.size() == mesh.positions.size() && (territory.empty() || territory.size() == open_.size()));
  const bool refined = refinement_ != surface.refinement;
  if (refined) {
    refinement_ = surface.refinement;
    rebuildTopology(*scene.character);
  }
  if (refined || territory_ != territory) {
    territory_ = territory;
    rebuildSkinValues(mesh);
  }
  drawsSeen_ = false;
  const bool known = scene.surfaceRevision != 0 && scene.surfaceRevision == revision_;
  if (refined || !known) {
    revision_ = scene.surfaceRevision;
    hasClasses_ = false;
    if (cardVertices_) takeCardVertices();
    else fillVertices(scene);
  }
  if (std::exchange(layers_, scene.layers) != scene.layers) hasClasses_ = false;
  if (showsClasses && !std::exchange(hasClasses_, true)) fillClasses(scene);
}

void SurfaceDrawer::leaveOutUnseen(const Frame& frame) {
  // Classes are indexed by the position among all triangles; other vertices are not known here.
  const bool placed = frame.settings.shading == Shading::kClasses || hasBeside_ || cardVertices_;
  if (!isSoftwareRenderer() || refinement_ == nullptr || placed) return;
  seen_.find({*refinement_, frame.scene.surface->positions, refinedOrder_, ranges_, showsBacks_},
             frame.view.clipFromWorld(), frame.view.size);
  uploadBuffer(seenIndices_, seen_.triangles(), GL_STREAM_DRAW);
  drawsSeen_ = true;
}

const GlProgram& SurfaceDrawer::prepareProgram(const Frame& frame, MapSet maps) const {
  const std::vector<const PrimitiveShape*> marks = markedShapes(frame);
  const PictureLook& look = frame.settings.look;
  SurfaceKind kind{.shading = frame.settings.shading, .wired = frame.settings.wire, .maps = maps};
  kind.marked = !marks.empty() || (frame.settings.territory && !territory_.empty());
  kind.colored = kind.shading == Shading::kTextured && !refinement_->drawColor.empty();
  kind.chosen = look.light != LightPreset::kStudio || look.occlusion;
  const GlProgram& program = programs_.of(kind);
  program.use();
  program.set("baseMap", 0);
  program.set("lineScale", frame.settings.lineScale);
  program.set("heatRange", std::max(frame.settings.heatRange, 1e-6f) * frame.height);
  std::array<glm::vec4, 9> stops{};
  std::ranges::transform(heatStops(), stops.begin(),
                         [](const glm::vec3& stop) { return glm::vec4(linearFromSrgb(stop), 1.0f); });
  program.set("heatStops", std::span<const glm::vec4>(stops));
  std::array<glm::vec4, kZones> zones{};
  for (std::size_t i = 0; i < zones.size(); ++i) zones[i] = glm::vec4(linearFromSrgb(zoneColor(i)), 1.0f);
  program.set("zoneColors", std::span<const glm::vec4>(zones));
  if (kind.marked) setMarks(program, frame, marks);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, classes_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, controlOf_.id());
  glBindVertexArray(array_.id());
  return program;
}

const Material& SurfaceDrawer::materialOf(const Range& range) const {
  const auto index = static_cast<std::size_t>(range.material);
  assert(index < materials_.size());
  return materials_[index];
}

AlphaMode SurfaceDrawer::alphaIn(const Frame& frame, const Material& material) {
  const bool solid = frame.settings.shading != Shading::kTextured || material.shownOpaque;
  return solid ? AlphaMode::kOpaque : material.alphaMode;
}

void SurfaceDrawer::drawRange(const GlProgram& program, const Frame& frame, const Range& range, MapSet maps) const {
  const Material& material = materialOf(range);
  const AlphaMode alpha = alphaIn(frame, material);
  // Without their maps, the factors would turn skin into chrome or into a lamp.
  const bool metal = material.metallicRoughnessMap.texture < 0 || (maps & kRoughnessBit) != 0;
  const bool glows = material.emissiveMap.texture < 0 || (maps & kEmissiveBit) != 0;
  program.set("baseColor", material.baseColor);
  program.set("finish", glm::vec4(metal ? material.metallic : 0.0f, material.roughness,
                                  alpha == AlphaMode::kMask ? material.alphaCutoff : -1.0f,
                                  alpha == AlphaMode::kBlend ? 1.0f : 0.0f));
  program.set("emissive", glows ? material.emissive : glm::vec3(0.0f));
  program.set("unlit", frame.settings.lighting && !material.unlit ? 0 : 1);
  program.set("firstTriangle", range.firstTriangle);
  textures_.bindBase(material);
  textures_.bindMaps(program, material, maps);
  drawTriangles(range.firstTriangle, range.triangles);
}

void SurfaceDrawer::drawTriangles(int firstTriangle, int triangles) const {
  const auto* const first =
      reinterpret_cast<const void*>(static_cast<std::uintptr_t>(firstTriangle) * 3 * sizeof(std::uint32_t));
  glDrawElements(GL_TRIANGLES, triangles * 3, GL_UNSIGNED_INT, first);
  if (!hasBeside_) return;
  glVertexArrayVertexBuffer(array_.id(), 0, besideVertices_.id(), 0, sizeof(Vertex));
  glDrawElements(GL_TRIANGLES, triangles * 3, GL_UNSIGNED_INT, first);
  glVertexArrayVertexBuffer(array_.id(), 0, vertices_.id(), 0, sizeof(Vertex));
}

/// Draws ranges with the programs that their materials' maps need, switching when they differ.
class SurfaceDrawer::OwnProgram {
 public:
  OwnProgram(const SurfaceDrawer& drawer, const Frame& frame) : drawer_(drawer), frame_(frame) {}

  void draw(const Range& range) {
    const MapSet maps = drawer_.textures_.mapsOf(drawer_.materialOf(range), frame_.settings);
    if (program_ == nullptr || maps != maps_) program_ = &drawer_.prepareProgram(frame_, maps);
    maps_ = maps;
    drawer_.drawRange(*program_, frame_, range, maps);
  }

 private:
  const SurfaceDrawer& drawer_;
  const Frame& frame_;
  const GlProgram* program_ = nullptr;
  MapSet maps_ = 0;
};

void SurfaceDrawer::drawOpaque(const Frame& frame) const {
  glDisable(GL_BLEND);
  if (refinement_ == nullptr) return;
  OwnProgram own(*this, frame);
  drawOpaqueRanges(frame, [&](const Range& range) { own.draw(range); });
}

void SurfaceDrawer::drawOpaque(const GlProgram& program, const Frame& frame) const {
  if (refinement_ == nullptr) return;
  glBindVertexArray(array_.id());
  drawOpaqueRanges(frame, [&](const Range& range) { drawRange(program, frame, range, 0); });
}

template <class Draw>
void SurfaceDrawer::drawOpaqueRanges(const Frame& frame, const Draw& draw) const {
  glVertexArrayElementBuffer(array_.id(), drawsSeen_ ? seenIndices_.id() : indices_.id());
  glCullFace(GL_BACK);
  for (const Range& range : drawsSeen_ ? seen_.ranges() : std::span<const Range>(ranges_)) {
    const Material& material = materialOf(range);
    if (alphaIn(frame, material) == AlphaMode::kBlend) continue;
    if (material.doubleSided) glDisable(GL_CULL_FACE);
    else glEnable(GL_CULL_FACE);
    draw(range);
  }
  glDisable(GL_CULL_FACE);
  glVertexArrayElementBuffer(array_.id(), indices_.id());
}

void SurfaceDrawer::drawBlended(const Frame& frame) const {
  if (refinement_ == nullptr) return;
  const auto blends = [&](const Range& range) { return alphaIn(frame, materialOf(range)) == AlphaMode::kBlend; };
  if (std::ranges::none_of(ranges_, blends)) return;
  OwnProgram own(*this, frame);
  blendPremultiplied();
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  for (const Range& range : ranges_) {
    if (!blends(range)) continue;
    for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
      if (hidden == GL_FRONT && !materialOf(range).doubleSided) continue;
      glCullFace(hidden);
      own.draw(range);
    }
  }
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

namespace {

constexpr float kHoveredPart = 0.52f;  // Opacity of the tint of a part.
constexpr float kChosenPart = 0.40f;
constexpr float kHiddenPart = 0.85f;  ///< Factor where the part is hidden.

}  // namespace

void SurfaceDrawer::drawForShadow(const Frame& frame, const GlProgram& solid, const GlProgram& withAlpha) const {
  if (refinement_ == nullptr) return;
  glBindVertexArray(array_.id());
  glVertexArrayElementBuffer(array_.id(), isSoftwareRenderer() ? shadowIndices_.id() : indices_.id());
  glVertexAttrib4f(5, 1.0f, 1.0f, 1.0f, 1.0f);  // For surfaces without colors.
  for (const Range& range : shadowRanges_) {
    const Material& material = materialOf(range);
    const AlphaMode alpha = alphaIn(frame, material);
    const GlProgram& program = alpha == AlphaMode::kOpaque ? solid : withAlpha;
    program.use();
    if (alpha != AlphaMode::kOpaque) {
      program.set("baseMap", 0);
      program.set("alpha", glm::vec2(material.baseColor.a, alpha == AlphaMode::kMask ? material.alphaCutoff : -1.0f));
      textures_.bindBase(material);
    }
    drawTriangles(range.firstTriangle, range.triangles);
  }
  glVertexArrayElementBuffer(array_.id(), indices_.id());
}

void SurfaceDrawer::drawPart(const Frame& frame, const LitPart& lit, float strength) const {
  if (lit.part >= static_cast<int>(materialOfPart_.size())) return;
  const int material = materialOfPart_[static_cast<std::size_t>(lit.part)];
  partProgram_.set("part", lit.part);
  partProgram_.set("tint", glm::vec4(linearFromSrgb(layerColor(lit.layer).srgb), strength));
  for (const Range& range : ranges_) {
    if (range.material == material) drawRange(partProgram_, frame, range, 0);
  }
}

void SurfaceDrawer::drawLitParts(const Frame& frame) const {
  if (refinement_ == nullptr || frame.scene.litParts.empty()) return;
  partProgram_.use();
  partProgram_.set("baseMap", 0);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, parts_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, controlOf_.id());
  glBindVertexArray(array_.id());
  glVertexAttrib4f(5, 1.0f, 1.0f, 1.0f, 1.0f);  // For surfaces without colors.
  blendPremultiplied();
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  for (const LitPart& lit : frame.scene.litParts) {
    const float strength = lit.hovered ? kHoveredPart : kChosenPart;
    glDepthFunc(GL_LEQUAL);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, partSeen_.id());
    drawPart(frame, lit, strength);
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    glDepthFunc(GL_GREATER);
    glBeginConditionalRender(partSeen_.id(), GL_QUERY_WAIT_INVERTED);
    drawPart(frame, lit, strength * kHiddenPart);
    glEndConditionalRender();
  }
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

namespace {

/// Refined triangles of control triangles, one after the other.
std::vector<int> refinedOf(const Refinement& refinement, std::span<const int> controls) {
  std::vector<int> refined;
  refined.reserve(refinement.drawTriangles.size());
  for (const int t : controls) {
    const int first = refinement.triangleBegin[static_cast<std::size_t>(t)];
    for (int i = 0; i < refinement.refinedTriangles(t); ++i) refined.push_back(first + i);
  }
  return refined;
}

}  // namespace

void SurfaceDrawer::rebuildOrder(const ControlMesh& mesh) {
  const auto materialIndex = [&](int t) { return mesh.triangles[static_cast<std::size_t>(t)].material; };
  controlOrder_.resize(mesh.triangles.size());
  std::iota(controlOrder_.begin(), controlOrder_.end(), 0);
  std::ranges::stable_sort(controlOrder_, {}, materialIndex);
  refinedOrder_ = refinedOf(*refinement_, controlOrder_);
  std::vector<std::array<std::uint32_t, 3>> ordered;
  std::vector<int> controlOf;
  ordered.reserve(refinedOrder_.size());
  controlOf.reserve(refinedOrder_.size());
  ranges_.clear();
  for (const int refined : refinedOrder_) {
    const int t = refinement_->controlOf[static_cast<std::size_t>(refined)];
    if (ranges_.empty() || ranges_.back().material != materialIndex(t)) {
      ranges_.push_back({materialIndex(t), static_cast<int>(ordered.size()), 0});
    }
    ordered.push_back(refinement_->drawTriangles[static_cast<std::size_t>(refined)]);
    controlOf.push_back(t);
    ++ranges_.back().triangles;
  }
  showsBacks_.clear();
  for (const Range& range : ranges_) showsBacks_.push_back(materialOf(range).doubleSided ? 1 : 0);
  uploadBuffer(indices_, std::span<const std::array<std::uint32_t, 3>>(ordered), GL_STATIC_DRAW);
  uploadBuffer(controlOf_, std::span<const int>(controlOf), GL_STATIC_DRAW);
  glVertexArrayElementBuffer(array_.id(), indices_.id());
}

void SurfaceDrawer::rebuildTopology(const Character& character) {
  const Refinement& refinement = *refinement_;
  rebuildOrder(character.mesh);
  uploadBuffer(uvs_, std::span<const glm::vec2>(refinement.drawUv), GL_STATIC_DRAW);
  uploadBuffer(colors_, std::span<const glm::vec4>(refinement.drawColor), GL_STATIC_DRAW);
  if (refinement.drawColor.empty()) glDisableVertexArrayAttrib(array_.id(), 5);
  else glEnableVertexArrayAttrib(array_.id(), 5);
  shadowRanges_ = ranges_;
  if (!isSoftwareRenderer()) return;
  const ShadowMesh shadow = makeShadowMesh(character, shadowClusters_, refinement, controlOrder_);
  uploadBuffer(shadowIndices_, std::span<const std::uint32_t>(shadow.indices), GL_STATIC_DRAW);
  shadowRanges_ = shadow.ranges;
}

}  // namespace sinew::app
