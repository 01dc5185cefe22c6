// tests/support/field_normals.cpp: `swell` alone, of one pose.

#include "tests/support/field_normals.h"

#include "core/character/skinning.h"
#include "core/rig/attachment.h"
#include "core/smoothing/patch.h"
#include "core/smoothing/rise_directions.h"
#include "core/smoothing/swell.h"

namespace sinew::test {

struct FieldNormals::State {
  const Character& character;
  Rig rig;
  Attachment attachment;
  CandidateLists candidates;
  std::vector<glm::vec3> riseInBind;
  Surface surface;
};

FieldNormals::FieldNormals(const Character& character, const Rig& rig)
    : state_(std::make_unique<State>(State{character, rig, attach(rig, character).value(), {}, {}, {}})) {
  state_->candidates = makeCandidateLists(character.mesh, state_->attachment);
  state_->riseInBind = riseDirections(character.mesh, kRise * character.height);
  state_->surface.refinement = std::make_shared<const Refinement>(refine(character.mesh, rig.smoothing.depth));
}

FieldNormals::~FieldNormals() = default;

const Surface& FieldNormals::at(const Pose& pose) {
  const auto& [character, rig, attachment, candidates, riseInBind, unused] = *state_;
  Surface& surface = state_->surface;
  const Refinement& refinement = *surface.refinement;
  SkinnedMesh control;
  skin(character, pose, control);
  const auto count = static_cast<std::size_t>(refinement.vertexCount);
  surface.positions.resize(count);
  surface.normals.resize(count);
  surface.displacement.assign(count, 0.0f);
  evaluatePatches(rig.smoothing.patch, character.mesh, refinement, control.positions, control.normals,
                  surface.positions, surface.normals);
  std::vector<glm::vec3> controlRise;
  skinDirections(character, riseInBind, pose, control, controlRise);
  std::vector<glm::vec3> rise(count);
  interpolateDirections(character.mesh, refinement, controlRise, rise);
  std::vector<PosedPrimitive> posed;
  poseField(attachment.primitives, pose.boneInWorld, posed);
  const SwellSettings settings{rig.surface.iso, rig.surface.skinBlend * character.height, rig.smoothing.projection,
                               1e-6 * static_cast<double>(character.height)};
  swell(character.mesh, FieldView{posed, &candidates, {}}, settings, rise, surface);
  return surface;
}

}  // namespace sinew::test
