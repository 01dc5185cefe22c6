// core/smoothing/smoother.cpp: the stages in order: skin -> patch -> project -> folds -> normals.
#include "sinew/smoothing/smoother.h"

#include <algorithm>
#include <cassert>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/base/stopwatch.h"
#include "core/character/skinning.h"
#include "core/drivers/driven_numbers.h"
#include "core/lines/carriers.h"
#include "core/mesh/creases.h"
#include "core/rig/attachment.h"
#include "core/rig/validation.h"
#include "core/smoothing/face_culling.h"
#include "core/smoothing/finish/fold_relaxation.h"
#include "core/smoothing/finish/fold_spread.h"
#include "core/smoothing/finish/lift_filter.h"
#include "core/smoothing/finish/shading_normals.h"
#include "core/smoothing/patches/patch.h"
#include "core/smoothing/projection/anchors.h"
#include "core/smoothing/projection/candidates.h"
#include "core/smoothing/projection/replace_vector.h"
#include "core/smoothing/projection/rise_directions.h"
#include "core/smoothing/projection/rise_limits.h"
#include "core/smoothing/projection/swell_vector.h"
#include "core/smoothing/triangle_classes.h"
#include "sinew/base/threads.h"

namespace sinew {
namespace {

constexpr double kRootTolerance = 1e-6;  ///< Fraction of H: a hundredth of the agreement docs/design.md promises.
constexpr float kSearchLength = 0.2f;    ///< L of `replace`, fraction of H.
constexpr int kLeastShared = 6'000;      ///< Refined vertices of `swell`: fewer are done before other threads wake.
constexpr int kLeastReplaced = 1'000;    ///< Of `replace`.
constexpr std::int64_t kMaxRefinedVertices = 16'000'000;  ///< 8 GiB: half a KiB each with all that is kept.

/// All that follows from a rig and a character, before any pose.
struct Prepared {
  Rig rig;  ///< Its driven numbers as they were in the pose that was smoothed last.
  DrivenNumbers driven;
  Attachment attachment;
  Carriers carriers;
  CandidateLists candidates;                   ///< Of all attached primitives, hidden or not.
  std::vector<int> hidden;                     ///< Indices into the rig's primitives, ascending.
  CandidateLists shown;                        ///< Those of candidates that are not hidden; made only where some are.
  int shownPrimitives = 0;                     ///< Attached and not hidden.
  std::shared_ptr<const ControlMesh> creased;  ///< The character's mesh with creased wedges; null if none are.
  std::shared_ptr<const Refinement> refinement;
  VertexTiles tiles;                   ///< Of seen().
  std::vector<Anchor> anchors;         ///< [V'] in `replace` with an anchored projection, else empty.
  std::vector<float> inverseLimits;    ///< [V'] of the rise.
  std::vector<std::uint8_t> isBorder;  ///< [V']
  VertexRings rings;
  std::vector<float> bindFronts;  ///< [T n^2] of the patch.
  ImplicitWeights weights;        ///< In `swell` omega alone, for the classes.
  std::vector<TriangleClass> classes;

  [[nodiscard]] const CandidateLists& seen() const { return hidden.empty() ? candidates : shown; }
  [[nodiscard]] bool swells() const { return rig.surface.mode == SurfaceMode::kSwell; }
};

SwellSettings swellSettings(const Rig& rig, const Character& character) {
  return {rig.surface.iso, rig.surface.skinBlend * character.height, rig.smoothing.projection,
          kRootTolerance * static_cast<double>(character.height)};
}

ReplaceSettings replaceSettings(const Rig& rig, const Character& character) {
  return {rig.surface.iso, kSearchLength * character.height, rig.smoothing.projection,
          kRootTolerance * static_cast<double>(character.height)};
}

}  // namespace

struct Smoother::State {
  std::shared_ptr<const Character> character;
  std::vector<glm::vec3> riseInBind;       ///< [V] this and the next depend on the character alone.
  std::vector<float> inverseLimitsInBind;  ///< [V]
  Prepared prepared;
  BlendingGraphMemo graphs;
  int attachments = 0;

  // Memory kept from pose to pose; never read before it is written.
  SkinnedMesh skinned;
  std::vector<glm::vec3> wedgeNormals;
  std::vector<glm::vec3> patchPositions;
  std::vector<glm::vec3> patchNormals;
  std::vector<glm::vec3> controlRise;
  std::vector<glm::vec3> rise;
  MovedTriangles movedTriangles;
  LiftFilter liftFilter;
  std::span<const float> filtered;  ///< Its weights.
  VertexPairs pairs;                ///< Of movedTriangles.corners, as the last stage left them.
  FoldRegion foldRegion;
  FoldMoves foldMoves;
  FoldRelaxation foldRelaxation;
  FoldSpread foldSpread;
  ShadingNormals shadingNormals;
  std::vector<PosedPrimitive> posed;
  FaceCulling culling;
  ProjectionScratch projection;
  std::vector<glm::vec3> flatPositions;
  std::vector<glm::vec3> flatNormals;
  std::vector<glm::vec3> anchorsInWorld;

  [[nodiscard]] const ControlMesh& mesh() const { return character->mesh; }

  /// From here on nothing can fail: what still serves is taken from the former preparation.
  Result<void> findCandidates(const Rig& rig, std::span<const int> hidden, Prepared& next) {
    next.hidden.assign(hidden.begin(), hidden.end());
    if (prepared.refinement && sameCandidates(prepared.rig, rig)) {
      next.attachment = std::move(prepared.attachment);
      next.candidates = std::move(prepared.candidates);
      reshape(rig, next.attachment);
      hide(next, prepared.hidden == next.hidden);
      if (prepared.hidden == next.hidden) next.tiles = std::move(prepared.tiles);
      return {};
    }
    Result<Attachment> attachment = attach(rig, *character, graphs);
    if (!attachment) return attachment.error();
    ++attachments;
    next.attachment = std::move(attachment).value();
    next.candidates = makeCandidateLists(mesh(), next.attachment);
    hide(next, false);
    return {};
  }

  /// @param known  the former preparation has hidden the same of the same candidates.
  void hide(Prepared& next, bool known) {
    std::vector<bool> isHidden;
    for (const int index : next.attachment.rigIndex) {
      isHidden.push_back(std::ranges::binary_search(next.hidden, index));
    }
    next.shownPrimitives = static_cast<int>(std::ranges::count(isHidden, false));
    if (next.hidden.empty()) return;
    next.shown = known ? std::move(prepared.shown) : withoutHidden(next.candidates, next.attachment, isHidden);
  }

  std::shared_ptr<const ControlMesh> creasedAt(float degrees) const {
    if (degrees >= kNoCreases) return nullptr;
    if (prepared.refinement && prepared.rig.smoothing.creaseAngle == degrees) return prepared.creased;
    auto result = std::make_shared<const ControlMesh>(sinew::creased(mesh(), degrees));
    return hasCreases(*result) ? result : nullptr;
  }

  std::shared_ptr<const Refinement> refinementFor(int depth, const std::shared_ptr<const ControlMesh>& creased) const {
    const bool same = prepared.refinement && prepared.refinement->depth == depth && prepared.creased == creased;
    return same ? prepared.refinement : std::make_shared<const Refinement>(refine(creased ? *creased : mesh(), depth));
  }

  void evaluate(PatchKind kind, const Refinement& refinement, const SkinnedMesh& control,
                std::vector<glm::vec3>& positions, std::vector<glm::vec3>& normals) const {
    positions.resize(static_cast<std::size_t>(refinement.vertexCount));
    normals.resize(positions.size());
    evaluatePatches(kind, mesh(), refinement, control.positions, control.normals, positions, normals);
  }

  void prepareVertices(Prepared& next) {
    if (prepared.refinement == next.refinement) {
      next.inverseLimits = std::move(prepared.inverseLimits);
      next.isBorder = std::move(prepared.isBorder);
      next.rings = std::move(prepared.rings);
      return;
    }
    next.inverseLimits.resize(static_cast<std::size_t>(next.refinement->vertexCount));
    interpolateValues(mesh(), *next.refinement, inverseLimitsInBind, next.inverseLimits);
    next.isBorder = borderVertices(mesh(), *next.refinement);
    next.rings = vertexRings(*next.refinement);
  }

  void prepareTiles(Prepared& next) const {
    if (prepared.refinement == next.refinement && !next.tiles.tiles.empty()) return;
    next.tiles = makeVertexTiles(mesh(), *next.refinement, next.seen());
  }

  void prepareFronts(Prepared& next) {
    const bool samePatch = prepared.rig.smoothing.patch == next.rig.smoothing.patch;
    if (prepared.refinement == next.refinement && samePatch) {
      next.bindFronts = std::move(prepared.bindFronts);
      return;
    }
    evaluate(next.rig.smoothing.patch, *next.refinement, {mesh().positions, mesh().normals}, patchPositions,
             patchNormals);
    next.bindFronts = triangleFronts(*next.refinement, patchPositions, patchNormals);
  }

  /// omega, classes and anchors: read off the bind pose.
  void prepareClasses(Prepared& next) {
    std::vector<PosedPrimitive> bindPrimitives;
    const Pose bind = bindPose(character->skeleton);
    poseField(next.attachment.primitives, next.carriers.inBind(character->skeleton), bindPrimitives);
    const FieldView bindField{bindPrimitives, &next.seen(), {}};
    if (!next.swells()) {
      const SkinnedMesh control{mesh().positions, mesh().normals};
      evaluate(PatchKind::kFlat, *next.refinement, control, flatPositions, flatNormals);
      const bool known = prepared.refinement == next.refinement && !prepared.anchors.empty();
      if (!known) next.anchors = findAnchors(character->skeleton, flatPositions);
      else if (&next != &prepared) next.anchors = std::move(prepared.anchors);
      poseAnchors(next.anchors, bind, anchorsInWorld);
      next.weights = implicitWeights(mesh(), bindField, replaceSettings(next.rig, *character),
                                     {flatPositions, flatNormals, anchorsInWorld}, projection);
    } else {
      next.weights = {influenceWeights(mesh(), bindField)};
    }
    next.classes = classifyTriangles(mesh(), next.weights.omega);
  }

  /// The rig's numbers as they are in a pose, and what follows from them.
  void drive(const Pose& pose) {
    Prepared& p = prepared;
    if (p.driven.isEmpty()) return;
    const DrivenChange change = p.driven.apply(pose, character->skeleton, p.rig);
    if (change.lines) p.carriers.settle(p.rig);
    if (!change.primitives) return;
    reshape(p.rig, p.attachment);
    prepareClasses(p);
  }

  /// Before the patch becomes the surface.
  void startShading(Surface& out) {
    out.shadingNormals.clear();
    if (!prepared.creased) return;
    skinWedgeNormals(*character, prepared.creased->wedges, skinned, wedgeNormals);
    out.shadingNormals.resize(out.refinement->drawVertex.size());
    evaluateShading(prepared.rig.smoothing.patch, *prepared.creased, *out.refinement, skinned.positions, wedgeNormals,
                    out.normals, out.shadingNormals);
  }

  /// Marks what the eye cannot see; the marks of a frame without an eye are empty.
  void cull(const FieldView& field, const std::optional<glm::vec3>& eye, Surface& out) {
    culling.clear();
    if (eye) {
      const bool moved = !prepared.swells() && prepared.shownPrimitives > 0;
      const auto classes = moved ? std::span<const TriangleClass>(prepared.classes) : std::span<const TriangleClass>();
      cullFaces({*character, *prepared.refinement, field, classes, out.positions}, *eye, culling);
    }
    out.culled = culling.triangles;
    out.report.culledTriangles = culling.culled;
  }

  void project(const Pose& pose, const std::optional<glm::vec3>& eye, Surface& out) {
    const Prepared& p = prepared;
    prepared.carriers.pose(p.attachment.primitives, pose, character->skeleton, posed);
    FieldView field{posed, &p.seen(), {}};
    cull(field, eye, out);
    if (p.shownPrimitives == 0) return;
    field.skipped = culling.carriers;
    if (p.swells()) {
      poseRiseDirections();
      swellAsChosen(mesh(), field, swellSettings(p.rig, *character), {rise, p.inverseLimits}, p.tiles, out, projection);
      return;
    }
    evaluate(PatchKind::kFlat, *p.refinement, skinned, flatPositions, flatNormals);
    poseAnchors(p.anchors, pose, anchorsInWorld);
    replaceAsChosen(mesh(), field, replaceSettings(p.rig, *character),
                    {flatPositions, flatNormals, anchorsInWorld, p.inverseLimits}, p.weights, p.tiles, out, projection);
  }

  void poseRiseDirections() {
    skinDirections(*character, riseInBind, skinned, controlRise);
    rise.resize(static_cast<std::size_t>(prepared.refinement->vertexCount));
    interpolateDirections(mesh(), *prepared.refinement, controlRise, rise);
  }

  /// Heights that the mesh cannot follow are filtered, folds smoothed out; what is still folded is spread.
  void unfold(Surface& out) {
    filtered = {};
    if (prepared.swells()) {  // `replace` lies on the muscle as it is.
      filtered = liftFilter.apply(prepared.rings, movedTriangles, patchPositions, out.positions, out.displacement);
    }
    pairs.fill(movedTriangles.corners, patchPositions, out.positions);
    foldMoves.start(out.positions.size());
    foldRegion.find(mesh(), *prepared.refinement, prepared.rings, movedTriangles,
                    {patchPositions, patchNormals, prepared.bindFronts}, pairs, out.positions,
                    FoldRelaxation::kWholeArea);
    foldRelaxation.apply(prepared.rings, prepared.isBorder, patchPositions, foldRegion, foldMoves, out.positions);
    foldSpread.apply(prepared.isBorder, patchPositions, foldRegion, foldMoves, out.positions);
    for (const auto& [vertex, from] : foldMoves.list()) {
      const auto v = static_cast<std::size_t>(vertex);
      pairs.moveTo(vertex, out.positions[v]);
      const glm::vec3 lift = from - patchPositions[v];
      out.displacement[v] *= glm::dot(out.positions[v] - patchPositions[v], lift) / glm::dot(lift, lift);
    }
    out.report.guarded = static_cast<int>(foldMoves.list().size());
  }

  /// Whether muscles have moved anything that can fold and is to be shaded. A surface that wraps the body may lie
  /// across its patch; it has the paper's normals.
  bool findMoved(const Surface& out) {
    if (!prepared.swells() && prepared.weights.wraps) return false;
    movedTriangles.find(mesh(), *prepared.refinement, prepared.rings, patchPositions, out.positions);
    return !movedTriangles.refined.empty();
  }

  void shade(bool moved, Surface& out) {
    if (moved) {
      shadingNormals.apply(*prepared.refinement, prepared.rings, movedTriangles, pairs, patchNormals, filtered,
                           out.normals);
    }
    if (!out.shadingNormals.empty()) turnWithSurface(out, patchNormals, out.shadingNormals);
  }

  void startReport(Surface& out) const {
    const Prepared& p = prepared;
    SmoothingReport& report = out.report;
    report = {};
    report.mode = p.rig.surface.mode;
    report.patch = p.rig.smoothing.patch;
    report.projection = p.rig.smoothing.projection;
    report.depth = p.refinement->depth;
    report.controlTriangles = static_cast<int>(mesh().triangles.size());
    report.refinedTriangles = static_cast<int>(p.refinement->triangles.size());
    report.refinedVertices = p.refinement->vertexCount;
    report.implicitTriangles = static_cast<int>(std::ranges::count(p.classes, TriangleClass::kImplicit));
    report.straddlingTriangles = static_cast<int>(std::ranges::count(p.classes, TriangleClass::kStraddling));
    report.normalTriangles = static_cast<int>(std::ranges::count(p.classes, TriangleClass::kNormal));
    report.unwrapped = p.weights.unwrapped;
    report.primitives = p.shownPrimitives;
    report.cliques = static_cast<int>(p.attachment.graph.cliques.size());
  }
};

Smoother::Smoother(std::shared_ptr<const Character> character) : state_(std::make_unique<State>()) {
  assert(character);
  state_->riseInBind = riseDirections(character->mesh, kRise * character->height);
  state_->inverseLimitsInBind = inverseRiseLimits(character->mesh, state_->riseInBind, kRise * character->height);
  state_->character = std::move(character);
}

Smoother::Smoother(std::unique_ptr<State> state) : state_(std::move(state)) {}
Smoother::~Smoother() = default;
Smoother::Smoother(Smoother&&) noexcept = default;
Smoother& Smoother::operator=(Smoother&&) noexcept = default;

Smoother Smoother::twin() const { return Smoother(std::make_unique<State>(*state_)); }

Result<void> Smoother::prepare(const Rig& rig, std::span<const int> hidden) {
  assert(std::ranges::is_sorted(hidden));
  if (Result<void> able = checkProcessor(); !able) return able.error();
  if (Result<void> valid = validate(rig, state_->graphs); !valid) return valid.error();
  const std::int64_t vertices = refinedVertexCount(state_->mesh(), rig.smoothing.depth);
  if (vertices > kMaxRefinedVertices) {
    return errorAt("smoothing.depth",
                   "depth " + std::to_string(rig.smoothing.depth) + " makes " + std::to_string(vertices) +
                       " vertices of this character; at most " + std::to_string(kMaxRefinedVertices) + " are possible",
                   "depth");
  }
  Prepared next;
  if (Result<void> reached = state_->findCandidates(rig, hidden, next); !reached) return reached.error();
  next.rig = rig;
  next.driven = {rig, *state_->character};
  next.carriers = {rig, *state_->character, next.attachment.lineCarriers};
  next.creased = state_->creasedAt(rig.smoothing.creaseAngle);
  next.refinement = state_->refinementFor(rig.smoothing.depth, next.creased);
  state_->prepareTiles(next);
  state_->prepareVertices(next);
  state_->prepareFronts(next);
  state_->prepareClasses(next);
  state_->prepared = std::move(next);
  return {};
}

void Smoother::smooth(const Pose& pose, Surface& out, const std::optional<glm::vec3>& eye) {
  State& state = *state_;
  assert(state.prepared.refinement && "prepare() first");
  std::optional<ThreadLimit> alone;
  const int leastShared = state.prepared.swells() ? kLeastShared : kLeastReplaced;
  if (state.prepared.refinement->vertexCount < leastShared) alone.emplace(1);
  Stopwatch watch;
  state.drive(pose);
  skin(*state.character, pose, state.skinned);
  const double skinSeconds = watch.lap();

  out.refinement = state.prepared.refinement;
  out.classes = state.prepared.classes;
  state.evaluate(state.prepared.rig.smoothing.patch, *out.refinement, state.skinned, out.positions, out.normals);
  out.displacement.assign(out.positions.size(), 0.0f);
  state.patchPositions = out.positions;
  state.patchNormals = out.normals;
  state.startShading(out);
  state.startReport(out);
  const double patchSeconds = watch.lap();

  state.project(pose, eye, out);
  const double projectSeconds = watch.lap();
  const bool moved = state.findMoved(out);
  if (moved) state.unfold(out);
  const double foldSeconds = watch.lap();
  state.shade(moved, out);
  out.report.seconds = {skinSeconds, patchSeconds, projectSeconds, foldSeconds, watch.lap()};
}

const Character& Smoother::character() const { return *state_->character; }
PreparationCounts Smoother::preparationCounts() const { return {state_->attachments, state_->graphs.enumerations()}; }
const std::vector<int>& Smoother::unattached() const { return state_->prepared.attachment.unattached; }

}  // namespace sinew
