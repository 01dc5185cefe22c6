// tests/support/surface/mesh_checks.h: what every surface must be, checked without the code under test.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "sinew/geometry/control_mesh.h"

namespace sinew::test {

/// Counts found by sorting directed edges.
struct EdgeCensus {
  int vertices = 0;  ///< Used by a triangle.
  int edges = 0;
  int triangles = 0;
  int borderEdges = 0;        ///< In one triangle.
  int crowdedEdges = 0;       ///< In more than two.
  int inconsistentEdges = 0;  ///< Run twice in the same direction: neighbors that disagree about the outside.
  [[nodiscard]] int euler() const { return vertices - edges + triangles; }
};

[[nodiscard]] EdgeCensus censusOf(std::span<const std::array<int, 3>> triangles);
[[nodiscard]] std::vector<std::array<int, 3>> trianglesOf(const ControlMesh& mesh);

/// Every edge has two triangles that run it in opposite directions.
[[nodiscard]] ::testing::AssertionResult isClosed(std::span<const std::array<int, 3>> triangles);
[[nodiscard]] ::testing::AssertionResult allFinite(std::span<const glm::vec3> points);
/// Lengths within 1e-4 of 1.
[[nodiscard]] ::testing::AssertionResult allUnit(std::span<const glm::vec3> normals);
/// Equal bit for bit.
[[nodiscard]] ::testing::AssertionResult sameBytes(std::span<const glm::vec3> a, std::span<const glm::vec3> b);
[[nodiscard]] bool sameBits(const glm::vec3& a, const glm::vec3& b);

/// The marked vertices and all that are at most so many edges away from one.
[[nodiscard]] std::vector<bool> grown(std::span<const std::array<int, 3>> triangles, std::vector<bool> marked,
                                      int edges);
/// Vertices that stand elsewhere in b than in a.
[[nodiscard]] std::vector<bool> movedBetween(std::span<const glm::vec3> a, std::span<const glm::vec3> b);

}  // namespace sinew::test
