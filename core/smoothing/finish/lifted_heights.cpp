// core/smoothing/finish/lifted_heights.cpp: places around all that has moved, and a list of what has a height.
#include "core/smoothing/finish/lifted_heights.h"

#include <cmath>

namespace sinew {

void LiftedHeights::start(const VertexRings& rings, const MovedTriangles& moved, std::span<const glm::vec3> patch,
                          std::span<const glm::vec3> positions, std::span<const float> heights) {
  rings_ = &rings;
  lifted_.clear();
  places_.resize(patch.size());
  for (const int vertex : moved.corners) {
    const glm::vec3& p = at(patch, vertex);
    const float height = at(heights, vertex);
    at(places_, vertex).of = {p.x, p.y, p.z, height};
    if (height != 0.0f && at(positions, vertex) != p) lifted_.push_back(vertex);
  }
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
