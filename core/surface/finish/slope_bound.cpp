// core/surface/finish/slope_bound.cpp: shortest paths from what is low, begun where a height is too steep.
#include "core/surface/finish/slope_bound.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/parallel.h"

namespace sinew {
namespace {

/// What a height leaves to a vertex of height `other` at the other end of a step of that length.
float leftBy(float height, float other, float length) {
  const float own = height != 0.0f && (height > 0.0f) == (other > 0.0f) ? std::abs(height) : 0.0f;
  return own + SlopeBound::kSlope * length;
}

/// All that a path can go to from a vertex in one step; the vertex itself may be among them.
template <class Visit>
void forEachStep(const VertexRings& rings, int vertex, Visit visit) {
  for (const int neighbor : rings.at(vertex)) visit(neighbor);
  for (const int across : rings.acrossFrom(vertex)) visit(across);
}

}  // namespace

void SlopeBound::offer(float height, int vertex) {
  offers_.push_back({height, vertex});
  std::ranges::push_heap(offers_, std::ranges::greater{}, &Offer::height);
}

void SlopeBound::findSteep(const LiftedHeights& heights) {
  constexpr std::size_t kFew = 1024;  // For one thread.
  const std::span<const int> lifted = heights.lifted();
  const SteepKernel kernel = steepKernel(chosenVectorSet());
  steep_.resize(lifted.size());
  steep_.resize(listInBlocks(lifted.size(), kFew, steep_.data(), [&](std::size_t begin, std::size_t end, int* steep) {
    return kernel({&heights.rings(), lifted.subspan(begin, end - begin), kSlope, heights.places(), steep});
  }));
}

/// Dijkstra's algorithm with every height as a start. Only vertices that are too steep for another one a step away can
/// be lowered first; so the search begins at those, and reaches others where a lowered one is too low for them. The
/// lowest offer is final when it is taken, since each further step adds to it. Sums of floats grow with both their
/// terms: the least over all paths is the same bits in whatever order it is found.
std::span<const int> SlopeBound::lower(LiftedHeights& heights) {
  const VertexRings& rings = heights.rings();
  findSteep(heights);
  offers_.clear();
  lowered_.clear();
  for (const int v : steep_) {
    const float own = heights.height(v);
    float least = std::abs(own);
    forEachStep(rings, v, [&](int other) {
      least = std::min(least, leftBy(heights.height(other), own, heights.distance(v, other)));
    });
    if (least < std::abs(own)) offer(least, v);
  }
  while (!offers_.empty()) {
    std::ranges::pop_heap(offers_, std::ranges::greater{}, &Offer::height);
    const auto [height, v] = offers_.back();
    offers_.pop_back();
    const float before = heights.height(v);
    if (!(height < std::abs(before))) continue;
    lowered_.push_back(v);
    heights.setHeight(v, std::copysign(height, before));
    forEachStep(rings, v, [&, from = v, least = height, before](int other) {
      const float own = heights.height(other);
      if (own == 0.0f || (own > 0.0f) != (before > 0.0f)) return;
      const float left = least + kSlope * heights.distance(from, other);
      if (left < std::abs(own)) offer(left, other);
    });
  }
  return lowered_;
}

}  // namespace sinew
