// core/smoothing/finish/lift_filter.cpp: weights from the first differences, then four rounds where they are not 0.
#include "core/smoothing/finish/lift_filter.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/base/smoothstep.h"

namespace sinew {
namespace {

constexpr float kBentFrom = 0.15f;  ///< c up to which the mesh follows the heights.
constexpr float kBentWhole = 0.5f;  ///< c from which the filter works whole.
constexpr float kStep = 0.5f;       ///< Of the way to the mean, a round.
constexpr int kRounds = 4;

float perLengthOf(const glm::vec3& edge) {
  const float squared = glm::dot(edge, edge);
  return squared > 0.0f ? 1.0f / std::sqrt(squared) : 0.0f;
}

}  // namespace

void LiftFilter::measureEdges(const Refinement& refinement, const MovedTriangles& moved,
                              std::span<const glm::vec3> patch, std::span<const float> heights) {
  links_.clear();
  sum_.assign(patch.size(), 0.0f);
  edges_.assign(patch.size(), 0.0f);
  for (const int triangle : moved.refined) {
    const std::array<int, 3>& t = at(refinement.triangles, triangle);
    if (at(heights, t[0]) == 0.0f && at(heights, t[1]) == 0.0f && at(heights, t[2]) == 0.0f) continue;
    Link& link = links_.emplace_back(Link{t, {}});
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(t[(i + 1) % 3]);
      const auto b = static_cast<std::size_t>(t[(i + 2) % 3]);
      const float perLength = perLengthOf(patch[b] - patch[a]);
      link.perLength[i] = perLength;
      sum_[a] += perLength;
      sum_[b] += perLength;
      edges_[a] += 1.0f;
      edges_[b] += 1.0f;
    }
  }
}

void LiftFilter::sumDifferences(std::span<const float> values) {
  for (const Link& link : links_) {
    for (const int v : link.corners) at(difference_, v) = 0.0f;
  }
  for (const Link& link : links_) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(link.corners[(i + 1) % 3]);
      const auto b = static_cast<std::size_t>(link.corners[(i + 2) % 3]);
      const float difference = link.perLength[i] * (values[b] - values[a]);
      difference_[a] += difference;
      difference_[b] -= difference;
    }
  }
}

bool LiftFilter::weigh(std::span<const float> heights) {
  difference_.resize(heights.size());
  own_.assign(heights.size(), 0.0f);
  sumDifferences(heights);
  bool any = false;
  for (const Link& link : links_) {
    for (const int vertex : link.corners) {
      const auto v = static_cast<std::size_t>(vertex);
      // (M - 1) s = difference / sum; the mean length is edges / sum.
      if (heights[v] == 0.0f || std::abs(difference_[v]) <= kBentFrom * edges_[v]) continue;
      own_[v] = smoothstep(kBentFrom, kBentWhole, std::abs(difference_[v]) / edges_[v]);
      any = true;
    }
  }
  if (!any) return false;
  weights_.assign(heights.size(), 0.0f);
  const auto mostOf = [](const std::vector<float>& values, const std::array<int, 3>& t) {
    return std::max({at(values, t[0]), at(values, t[1]), at(values, t[2])});
  };
  for (const Link& link : links_) {
    const float most = mostOf(own_, link.corners);
    if (most == 0.0f) continue;
    for (const int v : link.corners) at(weights_, v) = std::max(at(weights_, v), most);
  }
  std::erase_if(links_, [&](const Link& link) { return mostOf(weights_, link.corners) == 0.0f; });
  return true;
}

void LiftFilter::evenOut(std::span<const float> heights) {
  active_.clear();
  for (std::size_t v = 0; v < heights.size(); ++v) {
    if (weights_[v] > 0.0f && heights[v] != 0.0f) active_.push_back(static_cast<int>(v));
  }
  filtered_.assign(heights.begin(), heights.end());
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) sumDifferences(filtered_);
    for (const int vertex : active_) {
      const auto v = static_cast<std::size_t>(vertex);
      if (!(sum_[v] > 0.0f)) continue;
      const float next = filtered_[v] + kStep * weights_[v] * difference_[v] / sum_[v];
      filtered_[v] = std::clamp(next, std::min(0.0f, heights[v]), std::max(0.0f, heights[v]));
    }
  }
}

std::span<const float> LiftFilter::apply(const Refinement& refinement, const MovedTriangles& moved,
                                         std::span<const glm::vec3> patch, std::span<glm::vec3> positions,
                                         std::span<float> heights) {
  measureEdges(refinement, moved, patch, heights);
  if (!weigh(heights)) return {};
  evenOut(heights);
  for (const int vertex : active_) {
    const auto v = static_cast<std::size_t>(vertex);
    positions[v] = patch[v] + (filtered_[v] / heights[v]) * (positions[v] - patch[v]);
    heights[v] = filtered_[v];
  }
  return weights_;
}

}  // namespace sinew
