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
constexpr float kStep = 0.5f;       ///< Fraction of the way to the mean, per round.
constexpr int kRounds = 4;

std::size_t sixes(std::span<const int> ring) { return ring.size() / VertexRings::kMultiple; }

float differenceOf(std::span<const int> ring, const SixEdges* edges, std::span<const float> values, float own) {
  float difference = 0.0f;
  for (std::size_t i = 0; i < ring.size(); i += VertexRings::kMultiple, ++edges) {
    for (std::size_t k = 0; k < VertexRings::kMultiple; ++k) {
      difference += edges->perLength[SixEdges::kAt[k]] * (at(values, ring[i + k]) - own);
    }
  }
  return difference;
}

}  // namespace

void LiftFilter::sumEdges(const VertexRings& rings, const MovedTriangles& moved, std::span<const glm::vec3> patch,
                          std::span<const glm::vec3> positions, std::span<const float> heights) {
  moved_.clear();
  places_.resize(patch.size());
  std::size_t count = 0;
  for (const int vertex : moved.near) {
    const glm::vec3& p = at(patch, vertex);
    const float height = at(heights, vertex);
    at(places_, vertex).of = {p.x, p.y, p.z, height};
    if (height == 0.0f || at(positions, vertex) == p) continue;
    moved_.push_back(vertex);
    count += sixes(rings.at(vertex));
  }
  if (edges_.size() < count) edges_.resize(count);
  sums_.resize(moved_.size());
  liftKernel(chosenVectorSet())({&rings, moved_, places_.data(), edges_.data(), sums_.data()});
}

void LiftFilter::raise(int vertex, float weight) {
  float& now = at(weights_, vertex);
  if (now == 0.0f) weighted_.push_back(vertex);
  now = std::max(now, weight);
}

bool LiftFilter::weigh(const VertexRings& rings) {
  for (const int vertex : weighted_) {
    if (toIndex(vertex) < weights_.size()) at(weights_, vertex) = 0.0f;
  }
  weighted_.clear();
  weights_.resize(places_.size());
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    // (M - 1) s = difference / perLength; the mean length is the number of neighbors over that.
    const float bent = std::abs(sums_[i].difference) * at(rings.share, moved_[i]);
    if (bent <= kBentFrom) continue;
    const float weight = smoothstep(kBentFrom, kBentWhole, bent);
    raise(moved_[i], weight);
    for (const int neighbor : rings.at(moved_[i])) raise(neighbor, weight);
  }
  return !weighted_.empty();
}

void LiftFilter::findActive(const VertexRings& rings) {
  active_.clear();
  const SixEdges* edges = edges_.data();
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    if (at(weights_, moved_[i]) > 0.0f && sums_[i].perLength > 0.0f) active_.push_back({moved_[i], edges, sums_[i]});
    edges += sixes(rings.at(moved_[i]));
  }
}

void LiftFilter::evenOut(const VertexRings& rings, std::span<const float> heights) {
  filtered_.assign(heights.begin(), heights.end());
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) {
      for (Active& a : active_) {
        a.sums.difference = differenceOf(rings.at(a.vertex), a.edges, filtered_, at(filtered_, a.vertex));
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
std::span<const float> LiftFilter::apply(const VertexRings& rings, const MovedTriangles& moved,
                                         std::span<const glm::vec3> patch, std::span<glm::vec3> positions,
                                         std::span<float> heights) {
  sumEdges(rings, moved, patch, positions, heights);
  if (!weigh(rings)) return {};
  findActive(rings);
  evenOut(rings, heights);
  for (const Active& a : active_) {
    const auto v = toIndex(a.vertex);
    positions[v] = patch[v] + (filtered_[v] / heights[v]) * (positions[v] - patch[v]);
    heights[v] = filtered_[v];
  }
  return weights_;
}

}  // namespace sinew
