// core/surface/finish/lifted_heights.cpp: slopes bounded by shortest paths; a filter of four rounds.
#include "core/surface/finish/lifted_heights.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/formulas.h"
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

namespace {

/// Bound by a vertex of this height for one of height `other` at the given distance.
float leftBy(float height, float other, float length) {
  const float own = height != 0.0f && (height > 0.0f) == (other > 0.0f) ? std::abs(height) : 0.0f;
  return own + SlopeBound::kSlope * length;
}

/// Visits the vertices one step of a path away; may include the vertex itself.
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

/// Dijkstra's algorithm from every height. It starts at the vertices that are too steep against one a step away, the
/// only ones that can be lowered first, and reaches others from lowered ones. The lowest offer is final, since each
/// further step adds to it. Sums of floats are monotone in both terms, so the least over all paths has the same bits
/// in whatever order it is found.
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

namespace {

/// Sum over a ring of height differences per length.
float differenceOf(std::span<const int> ring, const SixEdges* edges, float own, std::span<const float> heights) {
  float difference = 0.0f;
  for (std::size_t i = 0; i < ring.size(); i += VertexRings::kMultiple, ++edges) {
    for (std::size_t k = 0; k < VertexRings::kMultiple; ++k) {
      difference += edges->perLength[SixEdges::kAt[k]] * (at(heights, ring[i + k]) - own);
    }
  }
  return difference;
}

}  // namespace

void LiftFilter::measure(const LiftedHeights& lifted) {
  std::size_t sixes = 0;
  for (const int v : lifted.lifted()) sixes += lifted.rings().at(v).size() / VertexRings::kMultiple;
  if (edges_.size() < sixes) edges_.resize(sixes);
  sums_.resize(lifted.lifted().size());
  liftKernel(chosenVectorSet())({&lifted.rings(), lifted.lifted(), lifted.places(), edges_.data(), sums_.data()});
}

void LiftFilter::raise(int vertex, float weight) {
  float& now = at(weights_, vertex);
  if (now == 0.0f) weighted_.push_back(vertex);
  now = std::max(now, weight);
}

bool LiftFilter::weigh(const LiftedHeights& lifted, std::size_t vertices) {
  for (const int vertex : weighted_) {
    if (toIndex(vertex) < weights_.size()) at(weights_, vertex) = 0.0f;
  }
  weighted_.clear();
  weights_.resize(vertices);
  const VertexRings& rings = lifted.rings();
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const int vertex = lifted.lifted()[i];
    // (M - 1) s = difference / perLength; the mean length is the number of neighbors / perLength.
    const float bent = std::abs(sums_[i].difference) * at(rings.share, vertex);
    if (bent <= in_float::kBentFrom) continue;
    const float weight = in_float::bentWeight(bent);
    raise(vertex, weight);
    const float rise = std::abs(lifted.height(vertex)) * sums_[i].perLength * at(rings.share, vertex);
    const float passed = in_float::passedWeight(weight, rise);
    if (passed == 0.0f) continue;
    for (const int neighbor : rings.at(vertex)) raise(neighbor, passed);
  }
  return !weighted_.empty();
}

void LiftFilter::findActive(const LiftedHeights& lifted) {
  active_.clear();
  const SixEdges* edges = edges_.data();
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const int vertex = lifted.lifted()[i];
    const bool isActive = at(weights_, vertex) > 0.0f && sums_[i].perLength > 0.0f && lifted.height(vertex) != 0.0f;
    if (isActive) active_.push_back({vertex, edges, sums_[i]});
    edges += lifted.rings().at(vertex).size() / VertexRings::kMultiple;
  }
}

void LiftFilter::evenOut(const VertexRings& rings, std::span<const float> heights) {
  filtered_.assign(heights.begin(), heights.end());
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) {
      for (Active& a : active_) {
        a.sums.difference = differenceOf(rings.at(a.vertex), a.edges, at(filtered_, a.vertex), filtered_);
      }
    }
    for (const Active& a : active_) {
      const float height = at(heights, a.vertex);
      float& filtered = at(filtered_, a.vertex);
      filtered =
          in_float::filteredHeight(filtered, at(weights_, a.vertex), a.sums.difference, a.sums.perLength, height);
    }
  }
}

/// The sums over the edges decide where the filter works and serve its first round. The other rounds visit only the
/// vertices with a weight, usually few, and read only the heights of the round before.
std::span<const float> LiftFilter::apply(const LiftedHeights& lifted, std::span<const glm::vec3> patch,
                                         std::span<glm::vec3> positions, std::span<float> heights) {
  measure(lifted);
  if (!weigh(lifted, heights.size())) return {};
  findActive(lifted);
  evenOut(lifted.rings(), heights);
  for (const Active& a : active_) {
    const auto v = toIndex(a.vertex);
    positions[v] = patch[v] + (filtered_[v] / heights[v]) * (positions[v] - patch[v]);
    heights[v] = filtered_[v];
  }
  return weights_;
}

}  // namespace sinew
