// core/smoothing/finish/shading_normals.cpp: memory for the kernel.
#include "core/smoothing/finish/shading_normals.h"

#include <algorithm>
#include <utility>

#include "core/base/at.h"
#include "core/base/parallel.h"

namespace sinew {
namespace {

constexpr std::size_t kBlock = 512;  ///< Vertices that one thread looks at.

}  // namespace

void ShadingNormals::apply(const Refinement& refinement, const VertexRings& rings, const MovedTriangles& moved,
                           const VertexPairs& pairs, std::span<const glm::vec3> patchNormals,
                           std::span<const float> filtered, std::span<glm::vec3> normals) {
  corners_.resize(rings.corners.size());
  vertices_.resize(normals.size());
  turns_.resize(normals.size());
  teeth_.resize(moved.corners.size());
  weights_.resize(moved.corners.size());
  const std::size_t blocks = (moved.corners.size() + kBlock - 1) / kBlock;
  teethOfBlock_.resize(blocks);
  const NormalsInputs inputs{&refinement, &rings,          &moved,           pairs.data(),  patchNormals, filtered,
                             normals,     corners_.data(), vertices_.data(), turns_.data(), teeth_,       weights_};
  const NormalsKernel kernel = normalsKernel(chosenVectorSet());
  const auto ofBlock = [&](std::size_t block) {
    return std::pair{block * kBlock, std::min((block + 1) * kBlock, moved.corners.size())};
  };
  forRanges(moved.refined.size(), 2 * kBlock,
            [&](std::size_t begin, std::size_t end) { kernel.faces(inputs, begin, end); });
  forRanges(moved.near.size(), kBlock, [&](std::size_t begin, std::size_t end) { kernel.hold(inputs, begin, end); });
  forEachIndex(blocks, 1, [&](std::size_t block) {
    const auto [begin, end] = ofBlock(block);
    teethOfBlock_[block] = kernel.findTeeth(inputs, begin, end);
  });
  forEachIndex(blocks, 1, [&](std::size_t block) { kernel.removeTeeth(inputs, block * kBlock, teethOfBlock_[block]); });
  for (const int vertex : moved.corners) {
    at(vertices_, vertex) = {};
    at(turns_, vertex) = 0.0f;
  }
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
