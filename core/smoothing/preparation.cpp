// core/smoothing/preparation.cpp: attach, refine, and read the bind pose; what did not change is shared.
#include "core/smoothing/preparation.h"

#include <algorithm>
#include <string>

#include "core/base/at.h"
#include "core/lanes/instruction_set.h"
#include "core/rig/validation.h"
#include "core/smoothing/finish/fold_relaxation.h"
#include "core/smoothing/patches/patch.h"
#include "core/smoothing/projection/rise_directions.h"
#include "core/smoothing/projection/rise_limits.h"
#include "core/smoothing/triangle_classes.h"

namespace sinew {
namespace {

constexpr double kRootTolerance = 1e-6;  ///< Fraction of H: a hundredth of the agreement docs/design.md promises.
constexpr float kSearchLength = 0.2f;    ///< L of `replace`, fraction of H.
constexpr std::int64_t kMaxRefinedVertices = 16'000'000;  ///< 8 GiB: half a KiB each with all that is kept.

Result<void> checkSize(const ControlMesh& mesh, int depth) {
  const std::int64_t vertices = refinedVertexCount(mesh, depth);
  if (vertices <= kMaxRefinedVertices) return {};
  return errorAt("smoothing.depth",
                 "depth " + std::to_string(depth) + " makes " + std::to_string(vertices) +
                     " vertices of this character; at most " + std::to_string(kMaxRefinedVertices) + " are possible",
                 "depth");
}

Result<std::shared_ptr<const AttachedRig>> attachRig(const Rig& rig, const Character& character,
                                                     const Preparation* former, BlendingGraphMemo& graphs) {
  if (former && sameCandidates(former->attached->rig, rig)) return former->attached;
  Result<Attachment> attachment = attach(rig, character, graphs);
  if (!attachment) return attachment.error();
  auto attached = std::make_shared<AttachedRig>();
  attached->rig = rig;
  attached->attachment = std::move(attachment).value();
  attached->candidates = makeCandidateLists(character.mesh, attached->attachment);
  return std::shared_ptr<const AttachedRig>(std::move(attached));
}

/// The candidate lists without hidden primitives, and how many are left.
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
  if (former && former->refined->creaseAngle == degrees) return former->refined->creased;
  auto result = std::make_shared<const ControlMesh>(creased(mesh, degrees));
  return hasCreases(*result) ? result : nullptr;
}

std::shared_ptr<const RefinedMesh> refineMesh(const CharacterTables& tables, const SmoothingSettings& smoothing,
                                              const Preparation* former) {
  const ControlMesh& mesh = tables.character->mesh;
  const std::shared_ptr<const ControlMesh> creased = creasedMesh(mesh, smoothing.creaseAngle, former);
  const RefinedMesh* known = former ? former->refined.get() : nullptr;
  if (known && known->refinement->depth == smoothing.depth && known->creased == creased) {
    if (known->creaseAngle == smoothing.creaseAngle) return former->refined;
    auto same = std::make_shared<RefinedMesh>(*known);
    same->creaseAngle = smoothing.creaseAngle;
    return same;
  }
  auto refined = std::make_shared<RefinedMesh>();
  refined->creased = creased;
  refined->creaseAngle = smoothing.creaseAngle;
  refined->refinement = std::make_shared<const Refinement>(refine(creased ? *creased : mesh, smoothing.depth));
  const Refinement& refinement = *refined->refinement;
  refined->inverseLimits.resize(toIndex(refinement.vertexCount));
  interpolateValues(mesh, refinement, tables.inverseLimitsInBind, refined->inverseLimits);
  refined->isBorder = borderVertices(mesh, refinement);
  refined->rings = vertexRings(refinement);
  return refined;
}

std::shared_ptr<const VertexTiles> tilesOf(const Preparation& next, const Preparation* former) {
  if (former && former->refined->refinement == next.refined->refinement && former->seen == next.seen) {
    return former->tiles;
  }
  return std::make_shared<const VertexTiles>(makeVertexTiles(next.mesh(), next.refinement(), *next.seen));
}

std::shared_ptr<const std::vector<float>> bindFrontsOf(const Preparation& next, const Preparation* former) {
  const bool known = former && former->refined->refinement == next.refined->refinement &&
                     former->smoothing.patch == next.smoothing.patch;
  if (known) return former->bindFronts;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  evaluatePatch(next, next.smoothing.patch, next.mesh().positions, next.mesh().normals, positions, normals);
  return std::make_shared<const std::vector<float>>(triangleFronts(next.refinement(), positions, normals));
}

std::shared_ptr<const std::vector<Anchor>> anchorsOf(const Preparation& next, const Preparation* former) {
  if (next.swells()) return nullptr;
  if (former && former->refined->refinement == next.refined->refinement && former->anchors) return former->anchors;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  evaluatePatch(next, PatchKind::kFlat, next.mesh().positions, next.mesh().normals, positions, normals);
  return std::make_shared<const std::vector<Anchor>>(findAnchors(next.character().skeleton, positions));
}

ImplicitWeights replaceWeights(const Preparation& preparation, const FieldView& bindField, const Pose& bind) {
  const ControlMesh& mesh = preparation.mesh();
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec3> anchors;
  evaluatePatch(preparation, PatchKind::kFlat, mesh.positions, mesh.normals, positions, normals);
  poseAnchors(*preparation.anchors, bind, anchors);
  ProjectionScratch scratch;
  return implicitWeights(mesh, bindField, replaceSettings(preparation), {positions, normals, anchors}, scratch);
}

}  // namespace

std::shared_ptr<const CharacterTables> characterTables(std::shared_ptr<const Character> character) {
  const float rise = kRise * character->height;
  std::vector<glm::vec3> directions = riseDirections(character->mesh, rise);
  std::vector<float> limits = inverseRiseLimits(character->mesh, directions, rise);
  return std::make_shared<const CharacterTables>(
      CharacterTables{std::move(character), std::move(directions), std::move(limits)});
}

Result<std::shared_ptr<const Preparation>> prepare(const std::shared_ptr<const CharacterTables>& tables, const Rig& rig,
                                                   const PreparationOptions& options, const Preparation* former,
                                                   BlendingGraphMemo& graphs) {
  const Character& character = *tables->character;
  if (Result<void> able = checkProcessor(); !able) return able.error();
  if (Result<void> valid = validate(rig, graphs); !valid) return valid.error();
  const int depth = options.depth.value_or(rig.smoothing.depth);
  if (Result<void> fits = checkSize(character.mesh, depth); !fits) return fits.error();
  Result<std::shared_ptr<const AttachedRig>> attached = attachRig(rig, character, former, graphs);
  if (!attached) return attached.error();

  auto next = std::make_shared<Preparation>();
  next->tables = tables;
  next->mode = rig.surface.mode;
  next->iso = rig.surface.iso;
  next->smoothing = rig.smoothing;
  next->smoothing.depth = depth;
  next->poser = options.poser ? options.poser : std::make_shared<const RigPoser>(rig, character);
  next->attached = std::move(attached).value();
  next->primitives = fieldPrimitives(rig, next->attached->attachment);
  hide(options.hidden, former, *next);
  next->refined = refineMesh(*tables, next->smoothing, former);
  next->tiles = tilesOf(*next, former);
  next->bindFronts = bindFrontsOf(*next, former);
  next->anchors = anchorsOf(*next, former);
  next->bind = readBindPose(*next, next->primitives);
  return std::shared_ptr<const Preparation>(std::move(next));
}

BindReading readBindPose(const Preparation& preparation, std::span<const FieldPrimitive> primitives) {
  const Pose bind = bindPose(preparation.character().skeleton);
  std::vector<PosedPrimitive> posed;
  poseField(primitives, bind.boneInWorld, posed);
  const FieldView bindField{posed, preparation.seen.get(), {}};
  BindReading reading;
  if (preparation.swells()) reading.weights = {influenceWeights(preparation.mesh(), bindField)};
  else reading.weights = replaceWeights(preparation, bindField, bind);
  reading.classes = classifyTriangles(preparation.mesh(), reading.weights.omega);
  return reading;
}

SwellSettings swellSettings(const Preparation& preparation, float skinBlend) {
  const float height = preparation.character().height;
  return {preparation.iso, skinBlend * height, preparation.smoothing.projection,
          kRootTolerance * static_cast<double>(height)};
}

ReplaceSettings replaceSettings(const Preparation& preparation) {
  const float height = preparation.character().height;
  return {preparation.iso, kSearchLength * height, preparation.smoothing.projection,
          kRootTolerance * static_cast<double>(height)};
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
