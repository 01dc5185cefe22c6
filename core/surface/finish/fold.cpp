// core/surface/finish/fold.cpp: areas along the patch, and how much the patch faces along its normals.
#include "core/surface/finish/fold.h"

#include "core/geometry/potential.h"

namespace sinew {
namespace {

/// Ratio of a patch triangle's front to its front in the bind pose, from which on its area is trusted fully.
constexpr float kWholeFront = 0.05f;

}  // namespace

std::vector<float> triangleFronts(const Refinement& refinement, std::span<const glm::vec3> positions,
                                  std::span<const glm::vec3> normals) {
  std::vector<float> fronts;
  fronts.reserve(refinement.triangles.size());
  for (const std::array<int, 3>& t : refinement.triangles) {
    fronts.push_back(frontOf(t, faceOf(t, positions), {positions, normals, {}}).ratio());
  }
  return fronts;
}

float trustIn(const Refinement& refinement, std::size_t triangle, const PatchView& patch, const glm::vec3& face) {
  const float bindFront = patch.bindFronts[triangle];
  if (!(bindFront > 0.0f)) return 0.0f;
  const float front = frontOf(refinement.triangles[triangle], face, patch).ratio();
  return smoothstep(0.0f, kWholeFront, front / bindFront);
}

}  // namespace sinew
