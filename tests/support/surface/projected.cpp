// tests/support/surface/projected.cpp: skin, patch, `swell` or `replace` of one pose.

#include "tests/support/surface/projected.h"

#include "core/character/skinning.h"
#include "core/lines/carriers.h"
#include "core/rig/attachment.h"
#include "core/smoothing/patches/patch.h"
#include "core/smoothing/projection/anchors.h"
#include "core/smoothing/projection/replace_vector.h"
#include "core/smoothing/projection/rise_directions.h"
#include "core/smoothing/projection/rise_limits.h"
#include "core/smoothing/projection/swell_vector.h"

namespace sinew::test {
namespace {

struct Points {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
};

Points patchOf(PatchKind kind, const ControlMesh& mesh, const Refinement& refinement, const SkinnedMesh& control) {
  const auto count = static_cast<std::size_t>(refinement.vertexCount);
  Points out{std::vector<glm::vec3>(count), std::vector<glm::vec3>(count)};
  evaluatePatches(kind, mesh, refinement, control.positions, control.normals, out.positions, out.normals);
  return out;
}

}  // namespace

struct Projected::State {
  const Character& character;
  Rig rig;
  Attachment attachment;
  Carriers carriers;
  CandidateLists candidates;
  VertexTiles tiles;
  std::vector<glm::vec3> riseInBind;
  std::vector<float> limitsInBind;
  std::vector<Anchor> anchors;
  ImplicitWeights weights;
  ProjectionScratch scratch{};
  Surface patch;
  Surface surface;
  Surface bindPatch;

  [[nodiscard]] double tolerance() const { return 1e-6 * static_cast<double>(character.height); }

  [[nodiscard]] ReplaceSettings replaceSettings() const {
    return {rig.surface.iso, 0.2f * character.height, rig.smoothing.projection, tolerance()};
  }

  void findWeights() {
    const Pose bind = bindPose(character.skeleton);
    const SkinnedMesh control{character.mesh.positions, character.mesh.normals};
    const Points flat = patchOf(PatchKind::kFlat, character.mesh, *surface.refinement, control);
    anchors = findAnchors(character.skeleton, flat.positions);
    std::vector<glm::vec3> inWorld;
    poseAnchors(anchors, bind, inWorld);
    std::vector<PosedPrimitive> posed;
    poseField(attachment.primitives, carriers.inBind(character.skeleton), posed);
    weights = implicitWeights(character.mesh, {posed, &candidates, {}}, replaceSettings(),
                              {flat.positions, flat.normals, inWorld}, scratch);
  }

  void swellFrom(const SkinnedMesh& control, const FieldView& field) {
    const Refinement& refinement = *surface.refinement;
    std::vector<glm::vec3> controlRise;
    skinDirections(character, riseInBind, control, controlRise);
    std::vector<glm::vec3> rise(static_cast<std::size_t>(refinement.vertexCount));
    interpolateDirections(character.mesh, refinement, controlRise, rise);
    const SwellSettings settings{rig.surface.iso, rig.surface.skinBlend * character.height, rig.smoothing.projection,
                                 tolerance()};
    std::vector<float> limits(rise.size());
    interpolateValues(character.mesh, refinement, limitsInBind, limits);
    swellAsChosen(character.mesh, field, settings, {rise, limits}, tiles, surface, scratch);
  }

  void replaceFrom(const SkinnedMesh& control, const Pose& pose, const FieldView& field) {
    const Points flat = patchOf(PatchKind::kFlat, character.mesh, *surface.refinement, control);
    std::vector<glm::vec3> inWorld;
    poseAnchors(anchors, pose, inWorld);
    std::vector<float> limits(flat.positions.size());
    interpolateValues(character.mesh, *surface.refinement, limitsInBind, limits);
    replaceAsChosen(character.mesh, field, replaceSettings(), {flat.positions, flat.normals, inWorld, limits}, weights,
                    tiles, surface, scratch);
  }
};

Projected::Projected(const Character& character, const Rig& rig)
    : state_(std::make_unique<State>(
          State{character, rig, attach(rig, character).value(), {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}})) {
  state_->carriers = Carriers(rig, character, state_->attachment.lineCarriers);
  state_->candidates = makeCandidateLists(character.mesh, state_->attachment);
  state_->riseInBind = riseDirections(character.mesh, kRise * character.height);
  state_->limitsInBind = inverseRiseLimits(character.mesh, state_->riseInBind, kRise * character.height);
  state_->surface.refinement = std::make_shared<const Refinement>(refine(character.mesh, rig.smoothing.depth));
  state_->tiles = makeVertexTiles(character.mesh, *state_->surface.refinement, state_->candidates);
  state_->patch.refinement = state_->bindPatch.refinement = state_->surface.refinement;
  Points bind = patchOf(rig.smoothing.patch, character.mesh, *state_->surface.refinement,
                        {character.mesh.positions, character.mesh.normals});
  state_->bindPatch.positions = std::move(bind.positions);
  state_->bindPatch.normals = std::move(bind.normals);
  if (rig.surface.mode == SurfaceMode::kReplace) state_->findWeights();
}

Projected::~Projected() = default;

std::size_t Projected::uncertified() const { return static_cast<std::size_t>(state_->surface.report.uncertified); }

const Surface& Projected::now() const { return state_->surface; }

const Surface& Projected::patch() const { return state_->patch; }

const Surface& Projected::bindPatch() const { return state_->bindPatch; }

const Surface& Projected::at(const Pose& pose) {
  const Character& character = state_->character;
  Surface& patch = state_->patch;
  Surface& surface = state_->surface;
  SkinnedMesh control;
  skin(character, pose, control);
  Points curved = patchOf(state_->rig.smoothing.patch, character.mesh, *surface.refinement, control);
  patch.positions = surface.positions = std::move(curved.positions);
  patch.normals = surface.normals = std::move(curved.normals);
  surface.report = {};
  surface.displacement.assign(surface.positions.size(), 0.0f);
  std::vector<PosedPrimitive> posed;
  state_->carriers.pose(state_->attachment.primitives, pose, character.skeleton, posed);
  const FieldView field{posed, &state_->candidates, {}};
  if (state_->rig.surface.mode == SurfaceMode::kSwell) {
    state_->swellFrom(control, field);
  } else {
    state_->replaceFrom(control, pose, field);
  }
  return surface;
}

}  // namespace sinew::test
