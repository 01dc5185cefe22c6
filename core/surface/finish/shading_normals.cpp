// core/surface/finish/shading_normals.cpp: memory and threads for the kernel.
#include "core/surface/finish/shading_normals.h"

#include <algorithm>

#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr std::size_t kBlock = 512;  ///< Vertices for one thread.

/// Calls use(block, begin, end) for blocks of `size` vertices.
template <class Use>
void forBlocks(std::size_t size, const Use& use) {
  forEachIndex((size + kBlock - 1) / kBlock, 1,
               [&](std::size_t block) { use(block, block * kBlock, std::min((block + 1) * kBlock, size)); });
}

}  // namespace

void ShadingNormals::apply(const Refinement& refinement, const VertexRings& rings, const MovedTriangles& moved,
                           const VertexPairs& pairs, std::span<const glm::vec3> patchNormals,
                           std::span<const float> filtered, bool softensRims, std::span<glm::vec3> normals) {
  corners_.resize(rings.corners.size());
  vertices_.resize(normals.size());
  turns_.resize(normals.size());
  teeth_.resize(moved.corners.size());
  weights_.resize(moved.corners.size());
  foundIn_.resize((moved.corners.size() + kBlock - 1) / kBlock);
  const NormalsInputs inputs{&refinement, &rings,          &moved,           pairs.data(),  patchNormals, filtered,
                             normals,     corners_.data(), vertices_.data(), turns_.data(), teeth_,       weights_};
  const NormalsKernel kernel = normalsKernel(chosenVectorSet());
  if (softensRims) softenRims(inputs, kernel);
  forRanges(moved.refined.size(), 2 * kBlock,
            [&](std::size_t begin, std::size_t end) { kernel.faces(inputs, begin, end); });
  forRanges(moved.near.size(), kBlock, [&](std::size_t begin, std::size_t end) { kernel.hold(inputs, begin, end); });
  forBlocks(moved.corners.size(), [&](std::size_t block, std::size_t begin, std::size_t end) {
    foundIn_[block] = kernel.findTeeth(inputs, begin, end);
  });
  forBlocks(moved.corners.size(), [&](std::size_t block, std::size_t begin, std::size_t) {
    kernel.removeTeeth(inputs, begin, foundIn_[block]);
  });
  forEachIndex(moved.corners.size(), 4 * kBlock, [&](std::size_t i) {
    at(vertices_, moved.corners[i]) = {};
    at(turns_, moved.corners[i]) = 0.0f;
  });
}

void ShadingNormals::softenRims(const NormalsInputs& inputs, const NormalsKernel& kernel) {
  const std::size_t near = inputs.moved->near.size();
  forRanges(inputs.moved->corners.size(), 2 * kBlock,
            [&](std::size_t begin, std::size_t end) { kernel.takeDeltas(inputs, begin, end); });
  forBlocks(near, [&](std::size_t block, std::size_t begin, std::size_t end) {
    foundIn_[block] = kernel.findRims(inputs, begin, end);
  });
  forBlocks(near, [&](std::size_t block, std::size_t begin, std::size_t) {
    kernel.softenRims(inputs, begin, foundIn_[block]);
  });
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
