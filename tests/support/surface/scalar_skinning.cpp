// tests/support/surface/scalar_skinning.cpp: linear blend skinning, one matrix a vertex, one vertex after the other.
#include "tests/support/surface/scalar_skinning.h"

#include "core/geometry/at.h"

namespace sinew::test {
namespace {

glm::mat4 blend(const ControlMesh& mesh, std::span<const glm::mat4> matrices, int vertex) {
  glm::mat4 sum(0.0f);
  for (const Influence& influence : mesh.influencesOf(vertex)) {
    sum += at(matrices, influence.binding) * influence.weight;
  }
  return sum;
}

/// A direction of the bind pose, unit, in the world.
glm::vec3 carry(const glm::vec3& direction, const glm::mat4& matrix) {
  return normalizeOr(normalMatrix(glm::mat3(matrix)) * direction, direction);
}

void skinVertices(const SkinInputs& inputs, std::size_t begin, std::size_t end) {
  for (std::size_t v = begin; v < end; ++v) {
    const glm::mat4 matrix = blend(*inputs.mesh, inputs.matrices, static_cast<int>(v));
    if (!inputs.outPositions.empty()) {
      inputs.outPositions[v] = glm::vec3(matrix * glm::vec4(inputs.positions[v], 1.0f));
    }
    inputs.outDirections[v] = carry(inputs.directions[v], matrix);
  }
}

void skinWedges(const WedgeInputs& inputs) {
  for (std::size_t w = 0; w < inputs.wedges.size(); ++w) {
    const Wedge& wedge = inputs.wedges[w];
    if (wedge.creased)
      inputs.out[w] = carry(inputs.normalOf(wedge), blend(*inputs.mesh, inputs.matrices, wedge.vertex));
  }
}

}  // namespace

SkinKernels scalarSkinKernels() { return {&skinVertices, &skinWedges}; }

}  // namespace sinew::test
