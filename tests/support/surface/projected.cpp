// tests/support/surface/projected.cpp: skin, patch, `swell` or `replace` of one pose.

#include "tests/support/surface/projected.h"

#include "core/surface/stages.h"

namespace sinew::test {
namespace {

std::shared_ptr<const Preparation> preparationOf(const Character& character, const Rig& rig,
                                                 ProjectionKind projection) {
  BlendingGraphMemo graphs;
  // The caller's character outlives this: nothing is owned.
  const std::shared_ptr<const Character> shared(std::shared_ptr<const Character>{}, &character);
  PreparationOptions options;
  options.projection = projection;
  return prepare(characterTables(shared), rig, options, nullptr, graphs).value();
}

}  // namespace

struct Projected::State {
  std::shared_ptr<const Preparation> preparation;
  PosedRig rig;
  PosedField posed;
  Workspace workspace;
  Surface patch;
  Surface surface;
  Surface bindPatch;
};

Projected::Projected(const Character& character, const Rig& rig, ProjectionKind projection)
    : state_(std::make_unique<State>()) {
  state_->preparation = preparationOf(character, rig, projection);
  at(bindPose(character.skeleton));
  state_->bindPatch.refinement = state_->preparation->refined->refinement;
  evaluatePatch(*state_->preparation, rig.smoothing.patch, character.mesh.positions, character.mesh.normals,
                state_->bindPatch.positions, state_->bindPatch.normals);
}

Projected::~Projected() = default;

std::size_t Projected::uncertified() const { return static_cast<std::size_t>(state_->surface.report.uncertified); }

const Surface& Projected::now() const { return state_->surface; }

const Surface& Projected::patch() const { return state_->patch; }

const Surface& Projected::bindPatch() const { return state_->bindPatch; }

const Surface& Projected::patchAt(const Pose& pose) {
  State& state = *state_;
  state.preparation->poser->pose(pose, state.rig);
  poseFieldAndSkin(state.preparation, state.rig, pose, state.posed);
  layPatch(*state.preparation, state.posed, state.workspace, state.patch);
  return state.patch;
}

const Surface& Projected::at(const Pose& pose) {
  State& state = *state_;
  state.surface = patchAt(pose);
  project(*state.preparation, state.posed, pose, std::nullopt, state.workspace, state.surface);
  return state.surface;
}

}  // namespace sinew::test
