// core/smoothing/finish/lift_edges.cpp: a list of what has a height; the kernel measures its edges.
#include "core/smoothing/finish/lift_edges.h"

#include <cmath>

namespace sinew {

void LiftEdges::measure(const VertexRings& rings, const MovedTriangles& moved, std::span<const glm::vec3> patch,
                        std::span<const glm::vec3> positions, std::span<const float> heights, float slope) {
  rings_ = &rings;
  lifted_.clear();
  moved_.clear();
  places_.resize(patch.size());
  indexOf_.resize(patch.size());
  std::size_t count = 0;
  for (const int vertex : moved.near) {
    const glm::vec3& p = at(patch, vertex);
    const float height = at(heights, vertex);
    at(places_, vertex).of = {p.x, p.y, p.z, height};
    at(indexOf_, vertex) = -1;
    if (height == 0.0f || at(positions, vertex) == p) continue;
    at(indexOf_, vertex) = static_cast<int>(lifted_.size());
    lifted_.push_back({vertex, count});
    moved_.push_back(vertex);
    count += rings.at(vertex).size() / VertexRings::kMultiple;
  }
  if (edges_.size() < count) edges_.resize(count);
  sums_.resize(moved_.size());
  liftKernel(chosenVectorSet())({&rings, moved_, slope, places_.data(), edges_.data(), sums_.data()});
}

void LiftEdges::sumAround(std::span<const int> vertices) {
  isSummed_.assign(lifted_.size(), 0);
  const auto sum = [&](int vertex) {
    const int index = at(indexOf_, vertex);
    if (index < 0 || at(isSummed_, index) != 0) return;
    at(isSummed_, index) = 1;
    at(sums_, index).difference = differenceOf(around(vertex), edges_.data() + at(lifted_, index).firstEdges,
                                               height(vertex), [&](int v) { return height(v); });
  };
  for (const int vertex : vertices) {
    sum(vertex);
    for (const int neighbor : around(vertex)) sum(neighbor);
  }
}

float LiftEdges::length(int a, int b) const {
  const auto& p = at(places_, a).of;
  const auto& q = at(places_, b).of;
  const float x = q[0] - p[0];
  const float y = q[1] - p[1];
  const float z = q[2] - p[2];
  return std::sqrt(x * x + y * y + z * z);
}

}  // namespace sinew
