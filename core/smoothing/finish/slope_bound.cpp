// core/smoothing/finish/slope_bound.cpp: shortest paths from what is low, begun where a height is too steep.
#include "core/smoothing/finish/slope_bound.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

/// What a height leaves to a neighbor on the other end of an edge that itself has the height `other`.
float leftBy(float height, float other) {
  return height != 0.0f && (height > 0.0f) == (other > 0.0f) ? std::abs(height) : 0.0f;
}

}  // namespace

void SlopeBound::offer(float height, int vertex) {
  offers_.push_back({height, vertex});
  std::ranges::push_heap(offers_, std::ranges::greater{}, &Offer::height);
}

/// Dijkstra's algorithm with every height as a start. Only vertices that are too steep for a neighbor can be lowered
/// first; so the search begins at those, and reaches others where a lowered one is too low for them. The lowest offer
/// is final when it is taken, since each further edge adds to it. Sums of floats grow with both their terms: the least
/// over all paths is the same bits in whatever order it is found.
std::span<const int> SlopeBound::lower(LiftEdges& edges) {
  offers_.clear();
  lowered_.clear();
  const std::span<const LiftSums> sums = edges.sums();
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (!(sums[i].steep > 0.0f)) continue;
    const int v = edges.lifted()[i].vertex;
    const float own = edges.height(v);
    float least = std::abs(own);
    for (const int neighbor : edges.around(v)) {
      least = std::min(least, leftBy(edges.height(neighbor), own) + kSlope * edges.length(v, neighbor));
    }
    if (least < std::abs(own)) offer(least, v);
  }
  while (!offers_.empty()) {
    std::ranges::pop_heap(offers_, std::ranges::greater{}, &Offer::height);
    const auto [height, v] = offers_.back();
    offers_.pop_back();
    const float before = edges.height(v);
    if (!(height < std::abs(before))) continue;
    lowered_.push_back(v);
    edges.setHeight(v, std::copysign(height, before));
    for (const int neighbor : edges.around(v)) {
      const float other = edges.height(neighbor);
      if (other == 0.0f || (other > 0.0f) != (before > 0.0f)) continue;
      const float left = height + kSlope * edges.length(v, neighbor);
      if (left < std::abs(other)) offer(left, neighbor);
    }
  }
  return lowered_;
}

}  // namespace sinew
