// tests/surface/finish/vertex_rings_test.cpp: vertex neighbors, counted once for every shared triangle.
#include "core/surface/finish/vertex_rings.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "tests/support/characters/body_with_arms.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/sheets.h"

namespace sinew::test {
namespace {

/// Weight of each neighbor in a vertex's mean.
using Shares = std::map<int, double>;

std::vector<Shares> sharesByTriangles(const Refinement& refinement) {
  std::vector<Shares> out(static_cast<std::size_t>(refinement.vertexCount));
  for (const auto& t : refinement.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = static_cast<std::size_t>(t[i]);
      for (const std::size_t other : {i + 1, i + 2}) out[v][t[other % 3]] += 0.5 / refinement.trianglesAt[v];
    }
  }
  return out;
}

/// Opposite corners across each edge, once for any two triangles that share one.
std::vector<std::vector<int>> acrossByTriangles(const Refinement& refinement) {
  std::map<std::array<int, 2>, std::vector<int>> thirds;
  for (const auto& t : refinement.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = t[(i + 1) % 3];
      const int b = t[(i + 2) % 3];
      thirds[{std::min(a, b), std::max(a, b)}].push_back(t[i]);
    }
  }
  std::vector<std::vector<int>> out(static_cast<std::size_t>(refinement.vertexCount));
  for (const auto& [edge, at] : thirds) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      for (std::size_t k = 0; k < at.size(); ++k) {
        if (i != k && at[i] != at[k]) out[static_cast<std::size_t>(at[i])].push_back(at[k]);
      }
    }
  }
  for (std::vector<int>& list : out) std::ranges::sort(list);
  return out;
}

void expectSame(const Refinement& refinement) {
  const VertexRings rings = vertexRings(refinement);
  const std::vector<Shares> expected = sharesByTriangles(refinement);
  const std::vector<std::vector<int>> across = acrossByTriangles(refinement);
  for (int v = 0; v < refinement.vertexCount; ++v) {
    const auto place = static_cast<std::size_t>(v);
    ASSERT_EQ(rings.at(v).size() % VertexRings::kMultiple, 0u);
    Shares shares;
    for (const int other : rings.at(v)) {
      if (other != v) shares[other] += static_cast<double>(rings.share[place]);
    }
    ASSERT_EQ(shares.size(), expected[place].size()) << v;
    for (const auto& [other, share] : expected[place]) EXPECT_NEAR(shares[other], share, 1e-6) << v;
    ASSERT_EQ(rings.acrossFrom(v).size() % VertexRings::kMultiple, 0u);
    std::vector<int> others(rings.acrossFrom(v).begin(), rings.acrossFrom(v).end());
    std::erase(others, v);
    std::ranges::sort(others);
    EXPECT_EQ(others, across[place]) << v;
    const std::span<const int> at = rings.cornersOf(v);
    EXPECT_EQ(at.size(), static_cast<std::size_t>(refinement.trianglesAt[place])) << v;
    EXPECT_TRUE(std::ranges::is_sorted(at));
    for (const int& corner : at) {
      const auto c = static_cast<std::size_t>(corner);
      EXPECT_EQ(refinement.triangles[c / 3][c % 3], v);
      EXPECT_EQ(&rings.corners[static_cast<std::size_t>(rings.placeOf[c])], &corner);
    }
  }
}

TEST(VertexRings, MatchASearchOnASheetWithBorders) {
  const Sheet sheet = sheetOf(4, [](float, float) { return 0.0f; });
  const ControlMesh mesh = meshOf(sheet.positions, sheet.triangles);
  for (const int depth : {1, 2, 3, 5}) expectSame(refine(mesh, depth));
}

// Edges with one, two and three triangles.
TEST(VertexRings, MatchASearchOnABodyWithAnOpenNeckAndAFin) { expectSame(refine(makeBodyWithArms()->mesh, 3)); }

TEST(VertexRings, ListEachNeighborOnceInsideAPatch) {
  const Refinement refinement = refine(makeBodyWithArms()->mesh, 5);
  const VertexRings rings = vertexRings(refinement);
  const int inside = refinement.insideBegin.front();
  ASSERT_EQ(rings.at(inside).size(), 6u);
  EXPECT_TRUE(std::ranges::adjacent_find(rings.at(inside)) == rings.at(inside).end());
}

}  // namespace
}  // namespace sinew::test
