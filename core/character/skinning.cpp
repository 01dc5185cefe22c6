// core/character/skinning.cpp: matrices of a pose, then the kernels.
#include "core/character/skinning.h"

#include "core/base/at.h"
#include "core/character/skinning_kernel.h"

namespace sinew {
namespace {

void poseMatrices(const Skeleton& skeleton, const Pose& pose, std::vector<glm::mat4>& out) {
  out.clear();
  for (const Binding& binding : skeleton.bindings) {
    out.push_back(at(pose.boneInWorld, binding.bone) * binding.inverseBind);
  }
}

}  // namespace

void skin(const Character& character, const Pose& pose, SkinnedMesh& out) {
  const ControlMesh& mesh = character.mesh;
  poseMatrices(character.skeleton, pose, out.matrices);
  out.positions.resize(mesh.positions.size());
  out.normals.resize(mesh.positions.size());
  skinKernels(chosenVectorSet()).vertices({&mesh, out.matrices, mesh.normals, out.positions, out.normals});
}

void skinDirections(const Character& character, std::span<const glm::vec3> bind, const SkinnedMesh& skinned,
                    std::vector<glm::vec3>& out) {
  out.resize(bind.size());
  skinKernels(chosenVectorSet()).vertices({&character.mesh, skinned.matrices, bind, {}, out});
}

void skinWedgeNormals(const Character& character, std::span<const Wedge> wedges, const SkinnedMesh& skinned,
                      std::vector<glm::vec3>& out) {
  out.resize(wedges.size());
  for (std::size_t w = 0; w < wedges.size(); ++w) out[w] = at(skinned.normals, wedges[w].vertex);
  skinKernels(chosenVectorSet()).wedges({&character.mesh, skinned.matrices, wedges, out});
}

}  // namespace sinew
