// core/character/skinning.cpp: linear blend skinning, one matrix a vertex.
#include "core/character/skinning.h"

#include "core/base/at.h"

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

}  // namespace

void skin(const Character& character, const Pose& pose, SkinnedMesh& out) {
  const ControlMesh& mesh = character.mesh;
  poseMatrices(character.skeleton, pose, out.matrices);
  const std::size_t count = mesh.positions.size();
  out.positions.resize(count);
  out.normals.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    const glm::mat4 matrix = blended(mesh, out.matrices, static_cast<int>(v));
    out.positions[v] = glm::vec3(matrix * glm::vec4(mesh.positions[v], 1.0f));
    out.normals[v] = normalizeOr(normalMatrix(glm::mat3(matrix)) * mesh.normals[v], mesh.normals[v]);
  }
}

void skinDirections(const Character& character, std::span<const glm::vec3> bind, const SkinnedMesh& skinned,
                    std::vector<glm::vec3>& out) {
  out = skinned.normals;
  for (std::size_t v = 0; v < bind.size(); ++v) {
    if (bind[v] == character.mesh.normals[v]) continue;
    const glm::mat3 matrix = normalMatrix(glm::mat3(blended(character.mesh, skinned.matrices, static_cast<int>(v))));
    out[v] = normalizeOr(matrix * bind[v], bind[v]);
  }
}

void skinWedgeNormals(const Character& character, std::span<const Wedge> wedges, const SkinnedMesh& skinned,
                      std::vector<glm::vec3>& out) {
  out.resize(wedges.size());
  for (std::size_t w = 0; w < wedges.size(); ++w) {
    const Wedge& wedge = wedges[w];
    out[w] = at(skinned.normals, wedge.vertex);
    if (!wedge.creased) continue;
    const glm::mat3 matrix = normalMatrix(glm::mat3(blended(character.mesh, skinned.matrices, wedge.vertex)));
    out[w] = normalizeOr(matrix * wedge.normal, wedge.normal);
  }
}

}  // namespace sinew
