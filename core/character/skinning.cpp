// core/character/skinning.cpp: linear blend skinning, one matrix a vertex, one vertex after the other: the reference of
// skinning_kernel.cpp.
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

glm::mat4 blended(const ControlMesh& mesh, std::span<const glm::mat4> matrices, int vertex) {
  glm::mat4 sum(0.0f);
  for (const Influence& influence : mesh.influencesOf(vertex)) {
    sum += at(matrices, influence.binding) * influence.weight;
  }
  return sum;
}

/// A direction of the bind pose, unit, in the world.
glm::vec3 carried(const glm::vec3& direction, const glm::mat4& matrix) {
  return normalizeOr(normalMatrix(glm::mat3(matrix)) * direction, direction);
}

void skinOneByOne(const SkinFrame& frame) {
  for (std::size_t v = 0; v < frame.directions.size(); ++v) {
    const glm::mat4 matrix = blended(*frame.mesh, frame.matrices, static_cast<int>(v));
    if (!frame.outPositions.empty()) {
      frame.outPositions[v] = glm::vec3(matrix * glm::vec4(frame.mesh->positions[v], 1.0f));
    }
    frame.outDirections[v] = carried(frame.directions[v], matrix);
  }
}

void skinWedgesOneByOne(const WedgeFrame& frame) {
  for (std::size_t w = 0; w < frame.wedges.size(); ++w) {
    const Wedge& wedge = frame.wedges[w];
    if (wedge.creased) frame.out[w] = carried(wedge.normal, blended(*frame.mesh, frame.matrices, wedge.vertex));
  }
}

SkinKernels chosenKernels() {
  const InstructionSet set = chosenInstructionSet();
  return set == InstructionSet::kScalar ? SkinKernels{&skinOneByOne, &skinWedgesOneByOne} : skinKernels(set);
}

}  // namespace

void skin(const Character& character, const Pose& pose, SkinnedMesh& out) {
  const ControlMesh& mesh = character.mesh;
  poseMatrices(character.skeleton, pose, out.matrices);
  out.positions.resize(mesh.positions.size());
  out.normals.resize(mesh.positions.size());
  chosenKernels().vertices({&mesh, out.matrices, mesh.normals, out.positions, out.normals});
}

void skinDirections(const Character& character, std::span<const glm::vec3> bind, const SkinnedMesh& skinned,
                    std::vector<glm::vec3>& out) {
  out.resize(bind.size());
  chosenKernels().vertices({&character.mesh, skinned.matrices, bind, {}, out});
}

void skinWedgeNormals(const Character& character, std::span<const Wedge> wedges, const SkinnedMesh& skinned,
                      std::vector<glm::vec3>& out) {
  out.resize(wedges.size());
  for (std::size_t w = 0; w < wedges.size(); ++w) out[w] = at(skinned.normals, wedges[w].vertex);
  chosenKernels().wedges({&character.mesh, skinned.matrices, wedges, out});
}

}  // namespace sinew
