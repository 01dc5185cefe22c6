// core/smoothing/finish/lift_filter.cpp: weights from the first differences, then four rounds where they are not 0.
#include "core/smoothing/finish/lift_filter.h"

#include <algorithm>
#include <cmath>

#include "core/base/at.h"
#include "core/base/smoothstep.h"

namespace sinew {
namespace {

constexpr float kBentFrom = 0.15f;  ///< c up to which the mesh follows the heights.
constexpr float kBentWhole = 0.5f;  ///< c from which the filter works whole.
constexpr float kRisen = 0.1f;      ///< Height, in edges, from which a vertex passes its weight on whole.
constexpr float kStep = 0.5f;       ///< Fraction of the way to the mean, per round.

}  // namespace

void LiftFilter::raise(int vertex, float weight) {
  float& now = at(weights_, vertex);
  if (now == 0.0f) weighted_.push_back(vertex);
  now = std::max(now, weight);
}

bool LiftFilter::weigh(const LiftEdges& edges, float followed, std::size_t vertices) {
  for (const int vertex : weighted_) {
    if (toIndex(vertex) < weights_.size()) at(weights_, vertex) = 0.0f;
  }
  weighted_.clear();
  weights_.resize(vertices);
  for (std::size_t i = 0; i < edges.lifted().size(); ++i) {
    const int vertex = edges.lifted()[i].vertex;
    // (M - 1) s = difference / perLength; the mean length is the number of neighbors over that.
    const float bent = std::abs(edges.sums()[i].difference) * at(edges.rings().share, vertex);
    if (bent <= kBentFrom) continue;
    float weight = smoothstep(kBentFrom, kBentWhole, bent);
    if (followed > 0.0f) {
      weight *= smoothstep(followed, 2.0f * followed, std::abs(edges.sums()[i].difference) / edges.sums()[i].perLength);
      if (weight == 0.0f) continue;
    }
    raise(vertex, weight);
    // Else a vertex that begins to move beside high ones would lower them at once.
    const float rise = std::abs(edges.height(vertex)) * edges.sums()[i].perLength * at(edges.rings().share, vertex);
    const float passed = weight * smoothstep(0.0f, kRisen, rise);
    if (passed == 0.0f) continue;
    for (const int neighbor : edges.around(vertex)) raise(neighbor, passed);
  }
  return !weighted_.empty();
}

void LiftFilter::findActive(const LiftEdges& edges) {
  active_.clear();
  for (std::size_t i = 0; i < edges.lifted().size(); ++i) {
    const auto [vertex, firstEdges] = edges.lifted()[i];
    const LiftSums& sums = edges.sums()[i];
    if (!(at(weights_, vertex) > 0.0f && sums.perLength > 0.0f) || edges.height(vertex) == 0.0f) continue;
    active_.push_back({vertex, edges.edges() + firstEdges, sums});
  }
}

void LiftFilter::evenOut(const LiftEdges& edges, std::span<const float> heights) {
  filtered_.assign(heights.begin(), heights.end());
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) {
      for (Active& a : active_) {
        a.sums.difference = differenceOf(edges.around(a.vertex), a.edges, at(filtered_, a.vertex),
                                         [&](int v) { return at(filtered_, v); });
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
std::span<const float> LiftFilter::apply(const LiftEdges& edges, float followed, std::span<const glm::vec3> patch,
                                         std::span<glm::vec3> positions, std::span<float> heights) {
  if (!weigh(edges, followed, heights.size())) return {};
  findActive(edges);
  evenOut(edges, heights);
  for (const Active& a : active_) {
    const auto v = toIndex(a.vertex);
    positions[v] = patch[v] + (filtered_[v] / heights[v]) * (positions[v] - patch[v]);
    heights[v] = filtered_[v];
  }
  return weights_;
}

}  // namespace sinew
