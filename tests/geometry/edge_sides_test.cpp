// tests/geometry/edge_sides_test.cpp: the sides at every edge, found by asking every triangle.

#include "core/geometry/edge_sides.h"

#include <gtest/gtest.h>

#include "core/geometry/weld.h"
#include "tests/geometry/soups.h"

namespace sinew {
namespace {

TEST(EdgeSides, AreThoseOfTheTrianglesInTheirOrder) {
  TriangleSoup soup = torus(7, 5);
  addTriangle(soup, soup.triangles[0][0], soup.triangles[0][1], soup.triangles[3][2]);  // A third one at an edge.
  const ControlMesh mesh = weld(soup, 1e-6f);
  const EdgeSides sides(mesh);
  std::size_t most = 0;
  for (int e = 0; e < static_cast<int>(mesh.edges.size()); ++e) {
    std::vector<std::array<int, 2>> expected;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      for (int i = 0; i < 3; ++i) {
        if (mesh.triangles[toIndex(t)].edges[toIndex(i)] == e) expected.push_back({t, i});
      }
    }
    std::vector<std::array<int, 2>> found;
    for (const auto& [triangle, side] : sides.of(e)) found.push_back({triangle, side});
    ASSERT_EQ(found, expected) << e;
    ASSERT_EQ(found.size(), toIndex(mesh.edges[toIndex(e)].triangleCount));
    most = std::max(most, found.size());
  }
  EXPECT_GE(most, 3u);
}

}  // namespace
}  // namespace sinew
