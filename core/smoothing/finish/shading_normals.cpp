// core/smoothing/finish/shading_normals.cpp: memory for the kernel.
#include "core/smoothing/finish/shading_normals.h"

#include "core/smoothing/finish/normals_kernel.h"

namespace sinew {

void ShadingNormals::apply(const Refinement& refinement, const VertexRings& rings, const MovedTriangles& moved,
                           const VertexPairs& pairs, std::span<const glm::vec3> patchNormals,
                           std::span<const float> filtered, std::span<glm::vec3> normals) {
  work_.resize(normals.size());
  teeth_.resize(normals.size());
  weights_.resize(normals.size());
  NormalsFrame frame{&refinement, &rings,  &moved,       pairs.data(),  patchNormals,
                     filtered,    normals, work_.data(), teeth_.data(), weights_.data()};
  normalsKernel(chosenVectorSet())(frame);
}

void turnWithSurface(const Surface& surface, std::span<const glm::vec3> patchNormals, std::vector<glm::vec3>& shading) {
  forEachDrawVertex(*surface.refinement, [&](std::size_t d, std::size_t vertex) {
    const glm::vec3& normal = surface.normals[vertex];
    const glm::vec3& patch = patchNormals[vertex];
    if (normal == patch) return;
    shading[d] = shading[d] == patch ? normal : normalizeOr(normal + (shading[d] - patch), shading[d]);
  });
}

}  // namespace sinew
