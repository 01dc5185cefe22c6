// core/character/skinning.cpp: matrices of a pose, then the kernels.
#include "core/character/skinning.h"

#include <cassert>

#include "core/character/skinning_kernel.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"

namespace sinew {
namespace {

void poseMatrices(const Skeleton& skeleton, const Pose& pose, std::vector<glm::mat4>& out) {
  out.clear();
  for (const Binding& binding : skeleton.bindings) {
    out.push_back(at(pose.boneInWorld, binding.bone) * binding.inverseBind);
  }
}

void skinVertices(const SkinInputs& inputs) {
  constexpr std::size_t kFew = 2048;  // For one thread.
  const SkinKernels kernels = skinKernels(chosenVectorSet());
  forRanges(inputs.directions.size(), kFew,
            [&](std::size_t begin, std::size_t end) { kernels.vertices(inputs, begin, end); });
}

}  // namespace

void skin(const Character& character, const Pose& pose, std::span<const float> morphWeights, SkinnedMesh& out) {
  const ControlMesh& mesh = character.mesh;
  if (character.morphTargets.empty()) out.morphed.isMorphed = false;
  else if (morphWeights.empty()) morph(character, morphWeightsOr(character, {}), out.morphed);
  else morph(character, morphWeights, out.morphed);
  const bool morphed = out.morphed.isMorphed;
  poseMatrices(character.skeleton, pose, out.matrices);
  out.positions.resize(mesh.positions.size());
  out.normals.resize(mesh.positions.size());
  skinVertices({&mesh, out.matrices, morphed ? out.morphed.positions : mesh.positions,
                morphed ? out.morphed.normals : mesh.normals, out.positions, out.normals});
}

void skin(const Character& character, const Pose& pose, SkinnedMesh& out) {
  skin(character, pose, pose.morphWeights, out);
}

void skinDirections(const Character& character, std::span<const glm::vec3> bind, const SkinnedMesh& skinned,
                    std::vector<glm::vec3>& out) {
  out.resize(bind.size());
  skinVertices({&character.mesh, skinned.matrices, {}, bind, {}, out});
}

void skinWedgeNormals(const Character& character, std::span<const Wedge> wedges, const SkinnedMesh& skinned,
                      std::vector<glm::vec3>& out) {
  out.resize(wedges.size());
  for (std::size_t w = 0; w < wedges.size(); ++w) out[w] = at(skinned.normals, wedges[w].vertex);
  WedgeInputs inputs{&character.mesh, skinned.matrices, wedges, {}, nullptr, out};
  if (skinned.morphed.isMorphed) {
    assert(skinned.morphed.fansMade);
    inputs.fanNormals = skinned.morphed.fanNormals;
    inputs.fanChanged = &skinned.morphed.fanChanged;
  }
  skinKernels(chosenVectorSet()).wedges(inputs);
}

}  // namespace sinew
