// core/surface/preparation.cpp: attaches, refines and reads the bind pose; shares unchanged parts.

#include "core/surface/preparation.h"

#include <algorithm>
#include <string>

#include "core/geometry/at.h"
#include "core/geometry/instruction_set.h"
#include "core/geometry/normals.h"
#include "core/geometry/parallel.h"
#include "core/rig/validation.h"
#include "core/surface/adaptive_levels.h"
#include "core/surface/finish/crease_lift.h"
#include "core/surface/finish/fold.h"
#include "core/surface/patches/patch.h"
#include "core/surface/projection/rise.h"
#include "sinew/geometry/control_mesh.h"

namespace sinew {
namespace {

constexpr std::size_t kFewClassified = 4096;  ///< Triangles for one thread.

/// [T] Implicit with omega = 1 at all three corners, normal with 0 at all, straddling otherwise (paper 3).
/// @param omega [V] 0 or 1.
void classifyTriangles(const ControlMesh& mesh, std::span<const float> omega, std::vector<TriangleClass>& classes) {
  classes.resize(mesh.triangles.size());
  forEachIndex(classes.size(), kFewClassified, [&](std::size_t t) {
    const auto isInside = [&](int vertex) { return at(omega, vertex) > 0.0f; };
    const auto inside = std::ranges::count_if(mesh.triangles[t].vertices, isInside);
    classes[t] = inside == 3   ? TriangleClass::kImplicit
                 : inside == 0 ? TriangleClass::kNormal
                               : TriangleClass::kStraddling;
  });
}

/// [V] omega in `swell`, used only by the overlay and the report: 1 inside some influence, else 0.
void influenceWeights(const ControlMesh& mesh, const FieldView& bindField, ImplicitWeights& weights) {
  std::vector<float>& omega = weights.omega;
  omega.assign(mesh.positions.size(), 0.0f);
  weights.wraps = true;
  weights.unwrapped = 0;
  forEachIndex(omega.size(), kFewClassified / 4, [&](std::size_t v) {
    const bool isInside =
        std::ranges::any_of(bindField.lists->of(static_cast<int>(v)), [&](const CarrierCandidate& candidate) {
          return at(bindField.primitives, candidate.primitive).influence.holds(mesh.positions[v]);
        });
    if (isInside) omega[v] = 1.0f;
  });
}

constexpr double kRootTolerance = 1e-6;                   ///< Fraction of H.
constexpr float kSearchLength = 0.2f;                     ///< L of `replace`, fraction of H.
constexpr std::int64_t kMaxRefinedVertices = 16'000'000;  ///< 8 GiB: half a KiB each with all tables.

Result<void> checkSize(const ControlMesh& mesh, int depth) {
  const std::int64_t vertices = refinedVertexCount(mesh, depth);
  if (vertices <= kMaxRefinedVertices) return {};
  return errorAt("smoothing.depth",
                 "depth " + std::to_string(depth) + " makes " + std::to_string(vertices) +
                     " vertices of this character; at most " + std::to_string(kMaxRefinedVertices) + " are possible",
                 "depth");
}

Result<void> checkSize(const ControlMesh& mesh, const RefinementLevels& levels) {
  auto vertices = static_cast<std::int64_t>(mesh.positions.size());
  for (const int level : levels.edges) vertices += level - 1;
  for (const int level : levels.triangles) vertices += (level - 1) * (level - 2) / 2;
  if (vertices <= kMaxRefinedVertices) return {};
  return errorAt("smoothing.tolerance",
                 "this tolerance makes " + std::to_string(vertices) + " vertices of this character; at most " +
                     std::to_string(kMaxRefinedVertices) + " are possible",
                 "tolerance");
}

Result<void> checkRegion(const ControlMesh& mesh, std::span<const std::uint8_t> region) {
  if (region.empty() || region.size() == mesh.triangles.size()) return {};
  return errorAt("region", "expected a mark for each of " + std::to_string(mesh.triangles.size()) + " triangles, got " +
                               std::to_string(region.size()));
}

std::shared_ptr<const LayeredSkin> layeredSkin(const CharacterTables& tables, const Rig& rig,
                                               const Preparation* former) {
  const Character& character = *tables.character;
  const std::vector<SkinLayer> parts = layersOf(rig, character, tables.guessedLayers);
  if (std::ranges::all_of(parts, [](SkinLayer layer) { return layer == SkinLayer::kSkin; })) return nullptr;
  if (former && former->layered && former->layered->layers.parts == parts) return former->layered;
  auto out = std::make_shared<LayeredSkin>();
  out->layers = meshLayers(character, parts);
  const SkinMesh skin = skinOf(character.mesh, out->layers);
  std::vector<glm::vec3> directions;
  for (const int v : skin.vertices) directions.push_back(at(tables.riseInBind, v));
  const std::vector<float> limits = inverseRiseLimits(skin.mesh, directions, kRise * character.height);
  out->inverseLimitsInBind.assign(character.mesh.positions.size(), 0.0f);
  for (std::size_t i = 0; i < limits.size(); ++i) at(out->inverseLimitsInBind, skin.vertices[i]) = limits[i];
  return out;
}

Result<std::shared_ptr<const AttachedRig>> attachRig(const Rig& rig, const Character& character,
                                                     const LayeredSkin* layered, const Preparation* former,
                                                     BlendingGraphMemo& graphs) {
  if (former && former->layered.get() == layered && sameCandidates(former->attached->rig, rig)) return former->attached;
  const bool relinks = former && former->layered.get() == layered && samePlaces(former->attached->rig, rig);
  Result<Attachment> attachment =
      relinks ? relinked(former->attached->attachment, rig, graphs) : attach(rig, character, graphs);
  if (!attachment) return attachment.error();
  auto attached = std::make_shared<AttachedRig>();
  attached->rig = rig;
  attached->attachment = std::move(attachment).value();
  attached->candidates =
      relinks ? relinked(former->attached->candidates, attached->attachment)
              : makeCandidateLists(character.mesh, attached->attachment, layered ? &layered->layers : nullptr);
  return std::shared_ptr<const AttachedRig>(std::move(attached));
}

/// Sets the candidate lists without hidden primitives, and the number of shown ones.
void hide(std::span<const int> hidden, const Preparation* former, Preparation& next) {
  const Attachment& attachment = next.attached->attachment;
  next.hidden.assign(hidden.begin(), hidden.end());
  std::vector<bool> isHidden;
  for (const int index : attachment.rigIndex) isHidden.push_back(std::ranges::binary_search(hidden, index));
  next.shownPrimitives = static_cast<int>(std::ranges::count(isHidden, false));
  if (former && former->attached == next.attached && former->hidden == next.hidden) next.seen = former->seen;
  else if (hidden.empty()) next.seen = {next.attached, &next.attached->candidates};
  else
    next.seen = std::make_shared<const CandidateLists>(withoutHidden(next.attached->candidates, attachment, isHidden));
}

std::shared_ptr<const ControlMesh> creasedMesh(const ControlMesh& mesh, float degrees, const Preparation* former) {
  if (degrees >= kNoCreases) return nullptr;
  if (former && former->smoothing.creaseAngle == degrees) return former->refined->creased;
  auto result = std::make_shared<const ControlMesh>(creased(mesh, degrees));
  return hasCreases(*result) ? result : nullptr;
}

/// Rings of control triangles refined around a region: steps against folds and steep skin seldom reach further.
constexpr int kRegionMargin = 3;

/// Adds triangles that share a vertex with the region.
void growRegion(const ControlMesh& mesh, Region& region) {
  std::vector<bool> isCorner(mesh.positions.size(), false);
  for (std::size_t t = 0; t < region.size(); ++t) {
    if (region[t] == 0) continue;
    for (const int v : mesh.triangles[t].vertices) isCorner[toIndex(v)] = true;
  }
  for (std::size_t t = 0; t < region.size(); ++t) {
    if (std::ranges::any_of(mesh.triangles[t].vertices, [&](int v) { return isCorner[toIndex(v)]; })) region[t] = 1;
  }
}

/// Keeps levels in the region and its margin; all others become 1. Edges at refined triangles keep theirs, so that no
/// crack opens at the border.  @param region [T]
RefinementLevels inRegion(const ControlMesh& mesh, RefinementLevels levels, const Region& region) {
  Region refined = region;
  for (int ring = 0; ring < kRegionMargin; ++ring) growRegion(mesh, refined);
  std::vector<bool> keeps(mesh.edges.size(), false);
  for (std::size_t t = 0; t < refined.size(); ++t) {
    if (refined[t] == 0) levels.triangles[t] = 1;
    else
      for (const int e : mesh.triangles[t].edges) keeps[toIndex(e)] = true;
  }
  for (std::size_t e = 0; e < keeps.size(); ++e) {
    if (!keeps[e]) levels.edges[e] = 1;
  }
  return levels;
}

Refinement refineBody(const Preparation& next, const ControlMesh& drawn) {
  if (next.region.empty()) {
    return next.detail ? refine(drawn, next.detail->levels, next.detail->splits) : refine(drawn, next.smoothing.depth);
  }
  RefinementLevels whole = next.detail ? next.detail->levels : uniformLevels(drawn, next.smoothing.depth);
  const RefinementLevels levels = inRegion(drawn, std::move(whole), next.region);
  return next.detail ? refine(drawn, levels, next.detail->splits) : refine(drawn, levels);
}

std::shared_ptr<const RefinedMesh> refineMesh(const Preparation& next, const Preparation* former) {
  const CharacterTables& tables = *next.tables;
  const ControlMesh& mesh = tables.character->mesh;
  const std::shared_ptr<const ControlMesh> creased = creasedMesh(mesh, next.smoothing.creaseAngle, former);
  const bool sameLevels = former && former->region == next.region &&
                          (next.detail ? former->detail && former->detail->levels == next.detail->levels &&
                                             former->detail->splits == next.detail->splits
                                       : !former->detail && former->smoothing.depth == next.smoothing.depth);
  if (sameLevels && former->refined->creased == creased && former->layered == next.layered) return former->refined;
  auto refined = std::make_shared<RefinedMesh>();
  refined->creased = creased;
  const ControlMesh& drawn = creased ? *creased : mesh;
  refined->refinement = std::make_shared<const Refinement>(refineBody(next, drawn));
  const Refinement& refinement = *refined->refinement;
  refined->inverseLimits.resize(toIndex(refinement.vertexCount));
  interpolateValues(mesh, refinement, next.inverseLimitsInBind(), refined->inverseLimits);
  refined->isBorder = borderVertices(mesh, refinement);
  refined->rings = vertexRings(refinement);
  return refined;
}

std::shared_ptr<const VertexTiles> tilesOf(const Preparation& next, const Preparation* former) {
  if (former && former->refined->refinement == next.refined->refinement && sameSeen(*former->seen, *next.seen)) {
    return former->tiles;
  }
  return std::make_shared<const VertexTiles>(makeVertexTiles(next.mesh(), next.refinement(), *next.seen));
}

/// Sets the tables made from the patch in the bind pose.
void readBindPatch(const Preparation* former, Preparation& next) {
  const bool known = former && former->refined == next.refined && former->smoothing.patch == next.smoothing.patch;
  if (known) {
    next.bindFronts = former->bindFronts;
    next.cloth = former->cloth;
    return;
  }
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  evaluatePatch(next, next.smoothing.patch, next.mesh().positions, next.mesh().normals, positions, normals);
  next.bindFronts = std::make_shared<const std::vector<float>>(triangleFronts(next.refinement(), positions, normals));
  if (!next.layered || !next.layered->layers.hasCloth()) return;
  next.cloth = std::make_shared<const ClothBinding>(bindCloth(next.mesh(), next.refinement(), next.refined->rings,
                                                              next.layered->layers, positions, normals,
                                                              next.character().height));
}

std::shared_ptr<const std::vector<Anchor>> anchorsOf(const Preparation& next, const Preparation* former) {
  if (next.swells()) return nullptr;
  if (former && former->refined->refinement == next.refined->refinement && former->anchors) return former->anchors;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  evaluatePatch(next, PatchKind::kFlat, next.mesh().positions, next.mesh().normals, positions, normals);
  return std::make_shared<const std::vector<Anchor>>(findAnchors(next.character().skeleton, positions));
}

void replaceWeights(const Preparation& preparation, const FieldView& bindField, BindScratch& scratch,
                    ImplicitWeights& out) {
  const ControlMesh& mesh = preparation.mesh();
  evaluatePatch(preparation, PatchKind::kFlat, mesh.positions, mesh.normals, scratch.positions, scratch.normals);
  poseAnchors(*preparation.anchors, preparation.tables->bind, scratch.anchors);
  implicitWeights(mesh, bindField, replaceSettings(preparation), {scratch.positions, scratch.normals, scratch.anchors},
                  scratch.projection, out);
}

}  // namespace

std::shared_ptr<const CharacterTables> characterTables(std::shared_ptr<const Character> character) {
  const float rise = kRise * character->height;
  std::vector<glm::vec3> directions = riseDirections(character->mesh, rise);
  std::vector<float> limits = inverseRiseLimits(character->mesh, directions, rise);
  std::vector<float> fronts = bindFrontInverses(character->mesh);
  std::vector<SkinLayer> layers = guessLayers(*character);
  Pose bind = bindPose(character->skeleton);
  return std::make_shared<const CharacterTables>(CharacterTables{std::move(character), std::move(bind),
                                                                 std::move(directions), std::move(limits),
                                                                 std::move(fronts), std::move(layers)});
}

Result<std::shared_ptr<const Preparation>> prepare(const std::shared_ptr<const CharacterTables>& tables, const Rig& rig,
                                                   const PreparationOptions& options, const Preparation* former,
                                                   BlendingGraphMemo& graphs) {
  const Character& character = *tables->character;
  if (Result<void> able = checkProcessor(); !able) return able.error();
  if (Result<void> valid = validate(rig, graphs); !valid) return valid.error();
  if (Result<void> fits = checkRegion(character.mesh, options.region); !fits) return fits.error();
  const bool adaptive = rig.smoothing.detail == DetailKind::kAdaptive && !options.depth;
  const int depth = options.depth.value_or(rig.smoothing.depth);
  if (Result<void> fits = checkSize(character.mesh, depth); !adaptive && !fits) return fits.error();
  std::shared_ptr<const LayeredSkin> layered = layeredSkin(*tables, rig, former);
  Result<std::shared_ptr<const AttachedRig>> attached = attachRig(rig, character, layered.get(), former, graphs);
  if (!attached) return attached.error();

  auto next = std::make_shared<Preparation>();
  next->tables = tables;
  next->mode = rig.surface.mode;
  next->iso = rig.surface.iso;
  next->smoothing = rig.smoothing;
  next->smoothing.depth = depth;
  next->projection = options.projection;
  next->poser = options.poser ? options.poser : std::make_shared<const RigPoser>(rig, character);
  next->layered = std::move(layered);
  next->attached = std::move(attached).value();
  next->primitives = fieldPrimitives(rig, next->attached->attachment);
  next->region.assign(options.region.begin(), options.region.end());
  hide(options.hidden, former, *next);
  if (adaptive) {
    const AdaptiveLevels* known = former && former->layered == next->layered ? former->detail.get() : nullptr;
    const float tolerance = options.tolerance.value_or(rig.smoothing.tolerance);
    if (options.keepLevels && known && known->from.tolerance == tolerance) next->detail = former->detail;
    else
      next->detail =
          findLevels(*next, options.shared ? options.shared : std::make_shared<const Rig>(rig), tolerance, known);
    if (Result<void> fits = checkSize(character.mesh, next->detail->levels); !fits) return fits.error();
  }
  next->refined = refineMesh(*next, former);
  next->tiles = tilesOf(*next, former);
  readBindPatch(former, *next);
  next->anchors = anchorsOf(*next, former);
  BindScratch scratch;
  readBindPose(*next, next->primitives, nullptr, scratch, next->bind);
  return std::shared_ptr<const Preparation>(std::move(next));
}

std::shared_ptr<const Preparation> prepareSamples(const Preparation& next, Refinement points) {
  auto own = std::make_shared<Preparation>(next);
  auto refined = std::make_shared<RefinedMesh>();
  refined->inverseLimits.resize(toIndex(points.vertexCount));
  interpolateValues(next.mesh(), points, next.inverseLimitsInBind(), refined->inverseLimits);
  refined->refinement = std::make_shared<const Refinement>(std::move(points));
  own->refined = std::move(refined);
  own->tiles = tilesOf(*own, nullptr);
  own->anchors = anchorsOf(*own, nullptr);
  BindScratch scratch;
  readBindPose(*own, own->primitives, nullptr, scratch, own->bind);
  return own;
}

void readBindPose(const Preparation& preparation, std::span<const FieldPrimitive> primitives,
                  const PosedCliqueSets* cliqueSets, BindScratch& scratch, BindReading& out) {
  const float grooves = preparation.poser->drawn().grooves * preparation.character().height;
  poseField(primitives, preparation.tables->bind.boneInWorld, grooves, scratch.primitives);
  const FieldView bindField{scratch.primitives, preparation.seen.get(), {}, cliqueSets};
  if (preparation.swells()) influenceWeights(preparation.mesh(), bindField, out.weights);
  else replaceWeights(preparation, bindField, scratch, out.weights);
  classifyTriangles(preparation.mesh(), out.weights.omega, out.classes);
}

SwellSettings swellSettings(const Preparation& preparation, float skinBlend) {
  const float height = preparation.character().height;
  return {preparation.iso, skinBlend * height, preparation.projection, kRootTolerance * static_cast<double>(height)};
}

ReplaceSettings replaceSettings(const Preparation& preparation) {
  const float height = preparation.character().height;
  return {preparation.iso, kSearchLength * height, preparation.projection, kRootTolerance * static_cast<double>(height),
          preparation.smoothing.alongNormals};
}

void evaluatePatch(const Preparation& preparation, PatchKind kind, std::span<const glm::vec3> controlPositions,
                   std::span<const glm::vec3> controlNormals, std::vector<glm::vec3>& positions,
                   std::vector<glm::vec3>& normals) {
  positions.resize(toIndex(preparation.refinement().vertexCount));
  normals.resize(positions.size());
  evaluatePatches(kind, preparation.mesh(), preparation.refinement(), controlPositions, controlNormals, positions,
                  normals);
}

}  // namespace sinew
