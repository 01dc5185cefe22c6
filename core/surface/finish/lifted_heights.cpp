// core/surface/finish/lifted_heights.cpp: places around all that has moved, and a list of what has a height.
#include "core/surface/finish/lifted_heights.h"

#include <cmath>

#include "core/geometry/parallel.h"

namespace sinew {

void LiftedHeights::start(const VertexRings& rings, const MovedTriangles& moved, std::span<const glm::vec3> patch,
                          std::span<const glm::vec3> positions, std::span<const float> heights) {
  constexpr std::size_t kFew = 2048;  // For one thread.
  rings_ = &rings;
  places_.resize(patch.size());
  lifted_.resize(moved.corners.size());
  const auto list = [&](std::size_t begin, std::size_t end, int* lifted) {
    std::size_t count = 0;
    for (const int vertex : std::span(moved.corners).subspan(begin, end - begin)) {
      const glm::vec3& p = at(patch, vertex);
      const float height = at(heights, vertex);
      at(places_, vertex).of = {p.x, p.y, p.z, height};
      if (height != 0.0f && at(positions, vertex) != p) lifted[count++] = vertex;
    }
    return count;
  };
  lifted_.resize(listInBlocks(moved.corners.size(), kFew, lifted_.data(), list));
}

float LiftedHeights::distance(int a, int b) const {
  const auto& p = at(places_, a).of;
  const auto& q = at(places_, b).of;
  const float x = q[0] - p[0];
  const float y = q[1] - p[1];
  const float z = q[2] - p[2];
  return std::sqrt(x * x + y * y + z * z);
}

}  // namespace sinew
