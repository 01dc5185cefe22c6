// core/character/skinning.cpp: linear blend skinning, one matrix a vertex.
#include "core/character/skinning.h"

namespace sinew {

void skin(const Character& character, const Pose& pose, SkinnedMesh& out) {
  const ControlMesh& mesh = character.mesh;
  const std::vector<Binding>& bindings = character.skeleton.bindings;
  std::vector<glm::mat4> skinMatrices;
  skinMatrices.reserve(bindings.size());
  for (const Binding& binding : bindings) {
    skinMatrices.push_back(pose.boneInWorld[static_cast<std::size_t>(binding.bone)] * binding.inverseBind);
  }
  const std::size_t count = mesh.positions.size();
  out.positions.resize(count);
  out.normals.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    glm::mat4 blended(0.0f);
    for (const Influence& influence : mesh.influencesOf(static_cast<int>(v))) {
      blended += skinMatrices[static_cast<std::size_t>(influence.binding)] * influence.weight;
    }
    out.positions[v] = glm::vec3(blended * glm::vec4(mesh.positions[v], 1.0f));
    out.normals[v] = normalizeOr(normalMatrix(glm::mat3(blended)) * mesh.normals[v], mesh.normals[v]);
  }
}

}  // namespace sinew
