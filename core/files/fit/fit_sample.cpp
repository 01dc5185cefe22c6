// core/files/fit/fit_sample.cpp: every so many vertices of a space-filling curve, and who is nearest to whom.
#include "core/files/fit/fit_sample.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include <glm/common.hpp>

#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

constexpr int kMortonBits = 20;   ///< Along each axis.
constexpr double kOwnVote = 2.0;  ///< What a cell's own weights count, where those of a cell beside it count 1.

/// Neighbors along edges, one list after the other.
struct Neighbors {
  std::vector<std::size_t> begin;  ///< [count+1]
  std::vector<int> others;         ///< Some twice.

  Neighbors(std::size_t count, std::span<const std::array<int, 3>> triangles) : begin(count + 1, 0) {
    const auto forEachEnd = [&](const auto& use) {
      for (const std::array<int, 3>& triangle : triangles) {
        if (std::ranges::any_of(triangle, [&](int corner) { return toIndex(corner) >= count; })) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          use(triangle[i], triangle[(i + 1) % 3]);
          use(triangle[(i + 1) % 3], triangle[i]);
        }
      }
    };
    forEachEnd([&](int from, int) { ++begin[toIndex(from) + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    others.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    forEachEnd([&](int from, int to) { others[next[toIndex(from)]++] = to; });
  }

  [[nodiscard]] std::span<const int> of(int vertex) const {
    return std::span(others).subspan(at(begin, vertex), at(begin, vertex + 1) - at(begin, vertex));
  }
};

/// Three numbers bit by bit.
std::uint64_t interleaved(const std::array<std::uint64_t, 3>& numbers) {
  std::uint64_t code = 0;
  for (int bit = kMortonBits - 1; bit >= 0; --bit) {
    for (const std::uint64_t number : numbers) code = (code << 1U) | ((number >> static_cast<unsigned>(bit)) & 1U);
  }
  return code;
}

/// Neighbors in the order are neighbors in space.
std::vector<int> mortonOrder(std::span<const glm::vec3> points) {
  glm::dvec3 low(points.front());
  glm::dvec3 high(low);
  for (const glm::vec3& point : points) {
    low = glm::min(low, glm::dvec3(point));
    high = glm::max(high, glm::dvec3(point));
  }
  const double side = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const double steps = side > 0.0 ? static_cast<double>((1U << kMortonBits) - 1U) / side : 0.0;
  std::vector<std::pair<std::uint64_t, int>> order;
  order.reserve(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const glm::dvec3 place = (glm::dvec3(points[v]) - low) * steps;
    const std::array<std::uint64_t, 3> numbers{static_cast<std::uint64_t>(place.x), static_cast<std::uint64_t>(place.y),
                                               static_cast<std::uint64_t>(place.z)};
    order.emplace_back(interleaved(numbers), static_cast<int>(v));
  }
  std::ranges::sort(order);
  std::vector<int> result;
  result.reserve(order.size());
  for (const auto& [code, vertex] : order) result.push_back(vertex);
  return result;
}

/// Gives every vertex that can be reached from those in `queue` the cell of the nearest of them.
void flood(const Neighbors& neighbors, std::vector<int> queue, std::vector<int>& cell) {
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const int other : neighbors.of(queue[i])) {
      if (at(cell, other) >= 0) continue;
      at(cell, other) = at(cell, queue[i]);
      queue.push_back(other);
    }
  }
}

std::vector<int> chosen(std::span<const glm::vec3> rest, const Neighbors& neighbors, std::size_t most) {
  const std::vector<int> order = mortonOrder(rest);
  std::vector<int> cell(rest.size(), -1);
  std::vector<int> vertices;
  for (std::size_t i = 0; i < most; ++i) {
    const std::size_t begin = i * order.size() / most;
    const std::size_t end = (i + 1) * order.size() / most;
    vertices.push_back(order[(begin + end) / 2]);
    at(cell, vertices.back()) = 0;
  }
  flood(neighbors, vertices, cell);
  for (int v = 0; v < static_cast<int>(cell.size()); ++v) {
    if (at(cell, v) >= 0) continue;
    at(cell, v) = 0;
    vertices.push_back(v);
    flood(neighbors, {v}, cell);
  }
  std::ranges::sort(vertices);
  return vertices;
}

void vote(const FourWeights& weights, double by, std::vector<Share>& votes) {
  for (std::size_t i = 0; i < kMostWeights && weights.binding[i] >= 0; ++i) {
    const auto place = std::ranges::lower_bound(votes, weights.binding[i], {}, &Share::binding);
    const double share = by * static_cast<double>(weights.weight[i]);
    if (place != votes.end() && place->binding == weights.binding[i]) place->weight += share;
    else votes.insert(place, {weights.binding[i], share});
  }
}

}  // namespace

FitSample sampleVertices(std::span<const glm::vec3> rest, std::span<const std::array<int, 3>> triangles,
                         std::size_t most) {
  FitSample sample;
  if (rest.size() <= most) {
    sample.vertices.resize(rest.size());
    std::iota(sample.vertices.begin(), sample.vertices.end(), 0);
    sample.cell = sample.vertices;
    sample.triangles.assign(triangles.begin(), triangles.end());
    return sample;
  }
  const Neighbors neighbors(rest.size(), triangles);
  sample.vertices = chosen(rest, neighbors, most);
  sample.cell.assign(rest.size(), -1);
  for (std::size_t i = 0; i < sample.vertices.size(); ++i) at(sample.cell, sample.vertices[i]) = static_cast<int>(i);
  flood(neighbors, sample.vertices, sample.cell);
  for (const std::array<int, 3>& triangle : triangles) {
    if (std::ranges::any_of(triangle, [&](int corner) { return toIndex(corner) >= rest.size(); })) continue;
    const int a = at(sample.cell, triangle[0]);
    const int b = at(sample.cell, triangle[1]);
    const int c = at(sample.cell, triangle[2]);
    if (a != b && b != c && c != a) sample.triangles.push_back({a, b, c});
  }
  return sample;
}

std::vector<std::vector<int>> candidatesNear(const FitSample& sample, std::span<const FourWeights> weights,
                                             std::span<const FourWeights> own) {
  const Neighbors neighbors(weights.size(), sample.triangles);
  std::vector<std::vector<int>> followed;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    std::vector<Share> votes;
    vote(weights[i], kOwnVote, votes);
    for (const int other : neighbors.of(static_cast<int>(i))) vote(weights[toIndex(other)], 1.0, votes);
    std::ranges::stable_sort(votes, std::ranges::greater{}, &Share::weight);
    std::vector<int>& list = followed.emplace_back();
    for (const Share& share : votes) list.push_back(share.binding);
  }
  std::vector<std::vector<int>> result;
  result.reserve(own.size());
  for (std::size_t v = 0; v < own.size(); ++v) {
    std::vector<int>& list = result.emplace_back();
    for (std::size_t i = 0; i < kMostWeights && own[v].binding[i] >= 0; ++i) list.push_back(own[v].binding[i]);
    for (const int binding : at(followed, sample.cell[v])) {
      if (list.size() >= kMostNear) break;
      if (std::ranges::find(list, binding) == list.end()) list.push_back(binding);
    }
  }
  return result;
}

}  // namespace sinew::exporting
