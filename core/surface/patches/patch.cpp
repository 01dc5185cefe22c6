// core/surface/patches/patch.cpp: control vertices are copied, kernels do the rest; scalars are interpolated here.
#include "core/surface/patches/patch.h"

#include <algorithm>

#include "core/geometry/at.h"

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
  std::ranges::copy(control, out.begin());
  for (const int e : refinement.edgeOrder) {
    const auto& ends = at(mesh.edges, e).vertices;
    for (int step = 1; step <= refinement.edgeVertices(e); ++step) {
      const auto w = static_cast<float>(refinement.shareAt(e, step));
      at(out, refinement.edgeVertex(e, step)) = (1.0f - w) * at(control, ends[0]) + w * at(control, ends[1]);
    }
  }
  for (const int t : refinement.insideOrder) {
    const auto& corners = at(mesh.triangles, t).vertices;
    for (int v = at(refinement.insideBegin, t); v < at(refinement.insideBegin, t + 1); ++v) {
      const glm::dvec2& place = refinement.insideAt(v);
      const auto w = static_cast<float>(place.x);
      const auto u = static_cast<float>(place.y);
      at(out, v) = (1.0f - w - u) * at(control, corners[0]) + w * at(control, corners[1]) + u * at(control, corners[2]);
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
