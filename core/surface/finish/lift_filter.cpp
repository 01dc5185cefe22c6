// core/surface/finish/lift_filter.cpp: weights from the first differences, then four rounds where they are not 0.
#include "core/surface/finish/lift_filter.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/at.h"
#include "core/geometry/potential.h"

namespace sinew {
namespace {

constexpr float kBentFrom = 0.15f;  ///< c up to which the mesh follows the heights.
constexpr float kBentWhole = 0.5f;  ///< c from which the filter works whole.
constexpr float kRisen = 0.1f;      ///< Height, in edges, from which a vertex passes its weight on whole.
constexpr float kStep = 0.5f;       ///< Fraction of the way to the mean, per round.

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
    // (M - 1) s = difference / perLength; the mean length is the number of neighbors over that.
    const float bent = std::abs(sums_[i].difference) * at(rings.share, vertex);
    if (bent <= kBentFrom) continue;
    const float weight = smoothstep(kBentFrom, kBentWhole, bent);
    raise(vertex, weight);
    // Else a vertex that begins to move beside high ones would lower them at once.
    const float rise = std::abs(lifted.height(vertex)) * sums_[i].perLength * at(rings.share, vertex);
    const float passed = weight * smoothstep(0.0f, kRisen, rise);
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
      const float next = filtered + kStep * at(weights_, a.vertex) * a.sums.difference / a.sums.perLength;
      filtered = std::clamp(next, std::min(0.0f, height), std::max(0.0f, height));
    }
  }
}

/// Lowers heights that the refined edges cannot follow, by a few steps towards the mean of the neighbors, weighted by
/// 1/length: that mean leaves heights alone that grow evenly. The sums over the edges decide where the filter works and
/// serve its first round; the other rounds visit only vertices with a weight, usually few. A round reads only the
/// heights of the one before, so that the order of vertices does not matter. docs/design.md, Sampling.
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
