// tests/support/surface/mesh_checks.cpp: what every surface must be.

#include "tests/support/surface/mesh_checks.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace sinew::test {

EdgeCensus censusOf(std::span<const std::array<int, 3>> triangles) {
  struct Run {
    int low;
    int high;
    bool upwards;
    bool operator<(const Run& other) const { return low != other.low ? low < other.low : high < other.high; }
  };
  EdgeCensus out;
  out.triangles = static_cast<int>(triangles.size());
  std::vector<Run> runs;
  std::vector<int> used;
  for (const auto& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = triangle[i];
      const int b = triangle[(i + 1) % 3];
      runs.push_back({std::min(a, b), std::max(a, b), a < b});
      used.push_back(a);
    }
  }
  std::sort(used.begin(), used.end());
  out.vertices = static_cast<int>(std::unique(used.begin(), used.end()) - used.begin());
  std::sort(runs.begin(), runs.end());
  for (std::size_t begin = 0; begin < runs.size();) {
    std::size_t end = begin;
    int upwards = 0;
    for (; end < runs.size() && !(runs[begin] < runs[end]); ++end) upwards += runs[end].upwards ? 1 : 0;
    const auto count = static_cast<int>(end - begin);
    ++out.edges;
    if (count == 1) ++out.borderEdges;
    if (count > 2) ++out.crowdedEdges;
    if (count == 2 && upwards != 1) ++out.inconsistentEdges;
    begin = end;
  }
  return out;
}

std::vector<std::array<int, 3>> trianglesOf(const ControlMesh& mesh) {
  std::vector<std::array<int, 3>> out;
  for (const ControlTriangle& triangle : mesh.triangles) out.push_back(triangle.vertices);
  return out;
}

::testing::AssertionResult isClosed(std::span<const std::array<int, 3>> triangles) {
  const EdgeCensus census = censusOf(triangles);
  if (census.triangles > 0 && census.borderEdges + census.crowdedEdges + census.inconsistentEdges == 0) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << census.triangles << " triangles, " << census.borderEdges << " border edges, "
                                       << census.crowdedEdges << " crowded edges, " << census.inconsistentEdges
                                       << " inconsistent edges";
}

::testing::AssertionResult allFinite(std::span<const glm::vec3> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3& p = points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      return ::testing::AssertionFailure() << "element " << i << " is (" << p.x << ", " << p.y << ", " << p.z << ")";
    }
  }
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult allUnit(std::span<const glm::vec3> normals) {
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const float size = glm::length(normals[i]);
    if (!(std::abs(size - 1.0f) < 1e-4f)) {
      return ::testing::AssertionFailure() << "normal " << i << " has length " << size;
    }
  }
  return ::testing::AssertionSuccess();
}

bool sameBits(const glm::vec3& a, const glm::vec3& b) { return std::memcmp(&a, &b, sizeof(glm::vec3)) == 0; }

::testing::AssertionResult sameBytes(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
  if (a.size() != b.size()) return ::testing::AssertionFailure() << a.size() << " elements against " << b.size();
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (sameBits(a[i], b[i])) continue;
    return ::testing::AssertionFailure() << "element " << i << ": (" << a[i].x << ", " << a[i].y << ", " << a[i].z
                                         << ") against (" << b[i].x << ", " << b[i].y << ", " << b[i].z << ")";
  }
  return ::testing::AssertionSuccess();
}

std::vector<bool> grown(std::span<const std::array<int, 3>> triangles, std::vector<bool> marked, int edges) {
  for (int round = 0; round < edges; ++round) {
    const std::vector<bool> before = marked;
    for (const auto& t : triangles) {
      if (!std::ranges::any_of(t, [&](int v) { return before[static_cast<std::size_t>(v)]; })) continue;
      for (const int v : t) marked[static_cast<std::size_t>(v)] = true;
    }
  }
  return marked;
}

std::vector<bool> movedBetween(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
  std::vector<bool> out(a.size());
  for (std::size_t v = 0; v < a.size(); ++v) out[v] = !sameBits(a[v], b[v]);
  return out;
}

}  // namespace sinew::test
