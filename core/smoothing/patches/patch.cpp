// core/smoothing/patches/patch.cpp: places of control vertices, then the kernels; single numbers are interpolated here.
#include "core/smoothing/patches/patch.h"

#include <algorithm>

#include "core/base/at.h"
#include "core/smoothing/patches/patch_kernel.h"

namespace sinew {

void evaluatePatches(PatchKind kind, const ControlMesh& mesh, const Refinement& refinement,
                     std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                     std::span<glm::vec3> outPositions, std::span<glm::vec3> outNormals) {
  std::ranges::copy(positions, outPositions.begin());
  std::ranges::copy(normals, outNormals.begin());
  patchKernels(chosenVectorSet()).patches({kind, &mesh, &refinement, positions, normals, outPositions, outNormals});
}

void interpolateDirections(const ControlMesh& mesh, const Refinement& refinement, std::span<const glm::vec3> control,
                           std::span<glm::vec3> out) {
  std::ranges::copy(control, out.begin());
  patchKernels(chosenVectorSet()).directions({&mesh, &refinement, control, out});
}

void interpolateValues(const ControlMesh& mesh, const Refinement& refinement, std::span<const float> control,
                       std::span<float> out) {
  const float n = static_cast<float>(refinement.depth);
  std::ranges::copy(control, out.begin());
  for (int e = 0; e < refinement.controlEdges && refinement.edgeVertices > 0; ++e) {
    const auto& ends = at(mesh.edges, e).vertices;
    for (int step = 1; step < refinement.depth; ++step) {
      const float w = static_cast<float>(step) / n;
      at(out, refinement.edgeVertex(e, step)) = (1.0f - w) * at(control, ends[0]) + w * at(control, ends[1]);
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t].vertices;
    for (int i = 0; i < refinement.interiorVertices; ++i) {
      const auto& [j, k] = at(refinement.interior, i);
      const float w = static_cast<float>(j) / n;
      const float u = static_cast<float>(k) / n;
      at(out, refinement.interiorVertex(static_cast<int>(t), i)) =
          (1.0f - w - u) * at(control, corners[0]) + w * at(control, corners[1]) + u * at(control, corners[2]);
    }
  }
}

void evaluateShading(PatchKind kind, const ControlMesh& mesh, const Refinement& refinement,
                     std::span<const glm::vec3> positions, std::span<const glm::vec3> wedgeNormals,
                     std::span<const glm::vec3> patchNormals, std::span<glm::vec3> outNormals) {
  forEachDrawVertex(refinement, [&](std::size_t d, std::size_t vertex) { outNormals[d] = patchNormals[vertex]; });
  for (std::size_t w = 0; w < mesh.wedges.size(); ++w) {
    if (mesh.wedges[w].creased) outNormals[w] = wedgeNormals[w];
  }
  patchKernels(chosenVectorSet()).shading({kind, &mesh, &refinement, positions, wedgeNormals, outNormals});
}

}  // namespace sinew
