// app/viewport/render/muscle_drawer.cpp: bellies, tendons, hollows and glass.
#include "app/viewport/render/muscle_drawer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "app/viewport/render/color_scales.h"
#include "app/viewport/render/overlay_drawers.h"
#include "core/character/bone_segments.h"
#include "core/rig/line_rest.h"
#include "sinew/geometry/shape.h"

namespace sinew::app {
namespace {

constexpr std::uint32_t kTendonRings = 24, kTendonCorners = 14;  ///< As in shaders/tendon.vert.
constexpr float kUnmoved = 0.45f;                                ///< Tone of muscles without a line.
constexpr float kStrandWidth = 0.12f;                 ///< Fraction of the mean of half length and mean radius across.
constexpr float kCord = 0.20f;                        ///< A tendon's radius over the belly's mean radius across,
constexpr glm::vec2 kCordOfHeight{0.0016f, 0.0085f};  ///< clamped to these fractions of the height.
constexpr glm::vec2 kBoneWidth{0.12f, 0.012f};        ///< Fractions of the bone's length and of the height.
constexpr float kShortestBone = 0.004f;               ///< Drawn, fraction of the height.
constexpr glm::vec3 kDarkContour{0.050f, 0.048f, 0.050f};  ///< Outline of the glass.
constexpr glm::vec3 kLightContour{0.330f, 0.345f, 0.370f};
constexpr float kSmall = 80.0f;   ///< Half axis in pixels below which 16 rows are exact to half a pixel.
constexpr float kInside = 0.97f;  ///< The tendon's first section over the belly's: hidden in it.

std::vector<std::uint32_t> tendonTriangles() {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t ring = 0; ring < kTendonRings; ++ring) {
    for (std::uint32_t place = 0; place < kTendonCorners; ++place) {
      const std::uint32_t next = (place + 1) % kTendonCorners, row = ring * kTendonCorners;
      const std::uint32_t a = row + place, b = row + next, above = a + kTendonCorners, beside = b + kTendonCorners;
      indices.insert(indices.end(), {a, above, b, b, above, beside});
    }
  }
  return indices;
}

/// The muscle's axes that become x, y and z when its fibres run along y.
std::array<glm::length_t, 3> axesOf(const PrimitiveShape& shape) {
  const glm::vec3& radii = shape.radii;
  if (!shape.shape.isPlain() || shape.sheet >= 0) return {0, 1, 2};
  if (radii.x > radii.y && radii.x >= radii.z) return {2, 0, 1};
  if (radii.z > radii.y) return {1, 2, 0};
  return {0, 1, 2};
}

/// Pseudo-random, 0..1.
float numberOf(int rigIndex) {
  const double golden = 0.6180339887498949 * (rigIndex + 1);
  return static_cast<float>(golden - std::floor(golden));
}

/// Activation, number of strands, ovalness and a number of the muscle, for shaders/muscle.frag.
glm::vec4 fibresOf(const PrimitiveShape& shape) {
  const std::array<glm::length_t, 3> axes = axesOf(shape);
  const float x = shape.radii[axes[0]], y = shape.radii[axes[1]], z = shape.radii[axes[2]];
  const float mean = 0.5f * (x + z);
  const float strands = 2.0f * std::numbers::pi_v<float> / kStrandWidth * std::sqrt(mean / y);
  return {shape.line ? shape.line->activation : kUnmoved, std::clamp(std::round(strands), 12.0f, 64.0f),
          (x - z) / (x + z), numberOf(shape.rigIndex)};
}

ShapeInstance instanceOf(const PrimitiveShape& shape) {
  ShapeInstance belly = shellOf(shape, 1.0f);
  belly.shapeInWorld = alongFibres(shape);
  belly.color = fibresOf(shape);
  belly.style.x = shape.hovered ? 1.0f : shape.selected ? 0.5f : 0.0f;
  return belly;
}

bool isSmall(const ShapeInstance& body, const View& view) {
  float halfAxis = 0.0f;
  for (glm::length_t i = 0; i < 3; ++i) halfAxis = std::max(halfAxis, glm::length(glm::vec3(body.shapeInWorld[i])));
  return halfAxis < kSmall * view.unitsPerPixelAt(glm::vec3(body.shapeInWorld[3]));
}

}  // namespace

glm::mat4 alongFibres(const PrimitiveShape& shape) {
  const std::array<glm::length_t, 3> axes = axesOf(shape);
  const glm::mat4& ball = shape.unitBallInWorld;
  return {ball[axes[0]], ball[axes[1]], ball[axes[2]], ball[3]};
}

MuscleDrawer::MuscleDrawer()
    : bellies_(ShapeMesh::ball(32)),
      smallBellies_(ShapeMesh::ball(16)),
      hollows_(ShapeMesh::ball(20)),
      bones_(ShapeMesh::ball(18)),
      tendonArray_(makeVertexArray()),
      tendonBuffer_(makeBuffer()),
      tendonIndices_(makeBuffer()) {
  const GLuint array = tendonArray_.id();
  glVertexArrayVertexBuffer(array, 0, tendonBuffer_.id(), 0, sizeof(TendonInstance));
  glVertexArrayBindingDivisor(array, 0, 1);
  const std::vector<std::uint32_t> indices = tendonTriangles();
  uploadBuffer(tendonIndices_, std::span<const std::uint32_t>(indices));
  glVertexArrayElementBuffer(array, tendonIndices_.id());
  for (GLuint i = 0; i < sizeof(TendonInstance) / sizeof(glm::vec4); ++i) {
    setAttribute(array, i, 0, 4, i * sizeof(glm::vec4));
  }
}

Result<MuscleDrawer> MuscleDrawer::create() {
  MuscleDrawer drawer;
  constexpr const char* kLit = "shaders/muscle.frag";
  constexpr const char* kDepth = "shaders/depth.frag";
  constexpr const char* kGlass = "shaders/glass.frag";
  const Result<void> loaded = loadPrograms(
      {{drawer.lit_.belly, {"shaders/muscle.vert", kLit}, {"CHOSEN_LOOK"}},
       {drawer.lit_.tendon, {"shaders/tendon.vert", kLit}, {"CHOSEN_LOOK"}},
       {drawer.lit_.bone, {"shaders/ivory.vert", kLit}, {"CHOSEN_LOOK", "BONE"}},
       {drawer.depth_.belly, {"shaders/muscle.vert", kDepth}, {"SOLID"}},
       {drawer.depth_.tendon, {"shaders/tendon.vert", kDepth}, {"SOLID"}},
       {drawer.depth_.bone, {"shaders/ivory.vert", kDepth}, {"SOLID"}},
       {drawer.hollow_, {"shaders/muscle.vert", "shaders/hollow.frag"}},
       {drawer.glass_, {"shaders/surface.vert", kGlass}, {"CHOSEN_LOOK", "COLORED", "GLASS"}},
       {drawer.glassDepth_, {"shaders/surface.vert", kGlass}, {"CHOSEN_LOOK", "COLORED", "GLASS", "DEPTH_ALONE"}},
       {drawer.wiredGlass_,
        {"shaders/surface.vert", "shaders/surface_wire.geom", kGlass},
        {"CHOSEN_LOOK", "COLORED", "GLASS", "WIRE"}}});
  if (!loaded) return loaded.error();
  return drawer;
}

void MuscleDrawer::addTendons(const PrimitiveShape& shape, const ShapeInstance& belly, float height) {
  const glm::vec3 x(belly.shapeInWorld[0]), z(belly.shapeInWorld[2]);
  const float halfLength = glm::length(glm::vec3(belly.shapeInWorld[1]));
  const float radius = std::clamp(kCord * std::sqrt(glm::length(x) * glm::length(z)), kCordOfHeight.x * height,
                                  kCordOfHeight.y * height);
  const std::vector<Tendon> tendons = tendonsOf(belly.shapeInWorld, shape.line->path, shape.shape.bend);
  for (const Tendon& tendon : tendons) {
    // A belly of a sheet is laid from origin to insertion.
    if (shape.sheet >= 0 && !(tendon.side < 0.0f ? shape.tendons.x : shape.tendons.y)) continue;
    const float first = kInside * sectionAt(shape.shape, tendon.side * kTendonStart);
    for (const TendonPart& part : tendon.parts) {
      TendonInstance& added = tendons_.emplace_back();
      const std::array<float, 4> ends{part.share.x, part.share.y, tendon.length / halfLength, radius};
      for (std::size_t i = 0; i < 4; ++i) added.curve[i] = glm::vec4(part.curve[i], ends[i]);
      added.halfX = glm::vec4(x, first);
      added.halfZ = glm::vec4(z, tendon.side * kTendonStart);
      added.fibres = belly.color;
      added.style = belly.style;
    }
  }
}

void MuscleDrawer::addBones(const Frame& frame) {
  std::vector<ShapeInstance> bones;
  const Scene& scene = frame.scene;
  if (frame.settings.skeleton && scene.pose != nullptr) {
    for (const BoneSegment& bone : boneSegments(scene.character->skeleton, *scene.pose, scene.hiddenBones)) {
      const float length = glm::distance(bone.head, bone.tail);
      if (length < kShortestBone * frame.height) continue;
      const float width = std::min(kBoneWidth.x * length, kBoneWidth.y * frame.height);
      bones.push_back({boneAlong(bone.head, bone.tail, width), glm::vec4(1.0f), glm::vec4(0, length / width, 0, 0)});
    }
  }
  bones_.setInstances(bones);
}

void MuscleDrawer::place(const Frame& frame) {
  for (const GlProgram* program : {&lit_.tendon, &depth_.tendon}) {
    program->use();
    program->set("pixel", 2.0f / (frame.view.clipFromView[1][1] * static_cast<float>(frame.view.size.y)));
  }
  addBones(frame);
  std::vector<ShapeInstance> large, small, hollows;
  tendons_.clear();
  for (const PrimitiveShape& shape : frame.scene.primitives) {
    const ShapeInstance body = instanceOf(shape);
    (shape.sign < 0 ? hollows : isSmall(body, frame.view) ? small : large).push_back(body);
    if (shape.sign > 0 && shape.line) addTendons(shape, body, frame.height);
  }
  const glm::vec3 forward = frame.view.forwardInWorld();
  const auto distance = [&](const ShapeInstance& body) { return glm::dot(glm::vec3(body.shapeInWorld[3]), forward); };
  // Front to back, so that hidden fragments are not shaded.
  std::ranges::stable_sort(large, std::less<>{}, distance);
  std::ranges::stable_sort(small, std::less<>{}, distance);
  std::ranges::stable_sort(hollows, std::greater<>{}, distance);
  hollowCount_ = hollows.size();
  bellies_.setInstances(large);
  smallBellies_.setInstances(small);
  hollows_.setInstances(hollows);
  uploadBuffer(tendonBuffer_, std::span<const TendonInstance>(tendons_));
}

void MuscleDrawer::drawBodies(const Programs& programs) const {
  glDisable(GL_BLEND);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  programs.belly.use();
  bellies_.draw();
  smallBellies_.draw();
  glDisable(GL_CULL_FACE);
  programs.bone.use();
  bones_.draw();
  if (tendons_.empty()) return;
  programs.tendon.use();
  glBindVertexArray(tendonArray_.id());
  glDrawElementsInstanced(GL_TRIANGLES, kTendonRings * kTendonCorners * 6, GL_UNSIGNED_INT, nullptr,
                          static_cast<GLsizei>(tendons_.size()));
}

void MuscleDrawer::drawFlesh(const Frame& frame) const {
  const Bounds& box = frame.surfaceBounds;
  const glm::vec3 middle = box.isEmpty() ? glm::vec3(0.0f) : box.center();
  const glm::vec3 forward = frame.view.forwardInWorld();
  const glm::vec3 half = box.isEmpty() ? glm::vec3(frame.height) : 0.5f * (box.high - box.low);
  const glm::vec2 range(glm::dot(middle - frame.view.eyeInWorld, forward), glm::dot(glm::abs(forward), half));
  for (const GlProgram* program : {&lit_.belly, &lit_.tendon, &lit_.bone}) {
    program->use();
    program->set("middle", range);
    program->set("loose", linearFromSrgb(fleshColor(0.0f)));
    program->set("flexed", linearFromSrgb(fleshColor(1.0f)));
  }
  drawBodies(lit_);
}

void MuscleDrawer::drawDepths() const { drawBodies(depth_); }

void MuscleDrawer::drawHollows() const {
  if (hollowCount_ == 0) return;
  blendPremultiplied();
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  hollow_.use();
  for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
    glCullFace(hidden);
    hollow_.set("inner", hidden == GL_FRONT ? 1.0f : 0.0f);
    hollows_.draw();
  }
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void MuscleDrawer::drawGlass(const Frame& frame, const SurfaceDrawer& surface) const {
  const bool wired = frame.settings.wire;
  const GlProgram& shown = wired ? wiredGlass_ : glass_;
  const GlProgram& depth = wired ? wiredGlass_ : glassDepth_;
  const glm::mat4& clip = frame.view.clipFromView;
  for (const GlProgram* program : {&depth, &shown}) {
    program->use();
    program->set("baseMap", 0);
    program->set("depthScale", glm::vec2(clip[2][2], clip[3][2]));
  }
  shown.set("plain", frame.settings.shading == Shading::kTextured ? 0 : 1);
  shown.set("clear", std::clamp(frame.settings.glass, 0.0f, 1.0f));
  shown.set("lineScale", frame.settings.lineScale);
  const BackdropStyle& backdrop = backdropStyle(frame.settings.look.backdrop);
  const bool onDark = frame.settings.background && backdrop.low.g + backdrop.high.g < 0.5f;
  shown.set("contourColor", onDark ? kLightContour : kDarkContour);
  glVertexAttrib4f(5, 1.0f, 1.0f, 1.0f, 1.0f);  // For surfaces without colors.
  // Depth first: only one layer of glass.
  glDisable(GL_BLEND);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  depth.use();
  surface.drawOpaque(depth, frame);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_EQUAL);
  blendPremultiplied();
  shown.use();
  surface.drawOpaque(shown, frame);
  glDisable(GL_BLEND);
  glDepthFunc(GL_LESS);
}

}  // namespace sinew::app
