// tests/geometry/topology_test.cpp: counts on shapes whose topology is known.

#include "core/geometry/weld.h"
#include "tests/support/euler_characteristic.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace sinew {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

Triangles cubeTriangles() {
  Triangles triangles;
  for (const auto& [a, b, c, d] :
       {std::array{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  return triangles;
}

Triangles torusTriangles(int around, int along) {
  Triangles triangles;
  const auto vertex = [&](int i, int j) { return i % around * along + j % along; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < along; ++j) {
      triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return triangles;
}

TEST(Topology, TetrahedronIsClosed) {
  const Topology t = topologyOf(Triangles{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
  EXPECT_EQ(t.vertices, 4);
  EXPECT_EQ(t.edges, 6);
  EXPECT_EQ(t.triangles, 4);
  EXPECT_EQ(eulerCharacteristic(t), 2);
  EXPECT_TRUE(t.closed());
}

TEST(Topology, CubeIsClosed) {
  const Topology t = topologyOf(cubeTriangles());
  EXPECT_EQ(t.vertices, 8);
  EXPECT_EQ(t.edges, 18);
  EXPECT_EQ(eulerCharacteristic(t), 2);
  EXPECT_TRUE(t.closed());
}

TEST(Topology, TorusIsClosed) {
  const Topology t = topologyOf(torusTriangles(7, 5));
  EXPECT_EQ(t.vertices, 35);
  EXPECT_EQ(eulerCharacteristic(t), 0);
  EXPECT_TRUE(t.closed());
}

TEST(Topology, OpenCubeHasABorder) {
  Triangles open = cubeTriangles();
  open.erase(open.begin(), open.begin() + 2);  // the face 0 3 2 1
  const Topology t = topologyOf(open);
  EXPECT_FALSE(t.closed());
  const std::vector<std::array<int, 2>> expected{{0, 1}, {0, 3}, {1, 2}, {2, 3}};
  EXPECT_EQ(t.borderEdges, expected);
  EXPECT_TRUE(t.nonManifoldEdges.empty());
  EXPECT_EQ(eulerCharacteristic(t), 1);
}

TEST(Topology, FinOnAnEdgeIsNonManifold) {
  Triangles finned = cubeTriangles();
  finned.push_back({0, 1, 8});
  const Topology t = topologyOf(finned);
  EXPECT_FALSE(t.closed());
  const std::vector<std::array<int, 2>> expected{{0, 1}};
  EXPECT_EQ(t.nonManifoldEdges, expected);
  EXPECT_EQ(t.borderEdges.size(), 2u);
}

TEST(Topology, EmptyMeshIsNotClosed) {
  const Topology t = topologyOf(Triangles{});
  EXPECT_FALSE(t.closed());
  EXPECT_EQ(t.vertices, 0);
}

TEST(Topology, UnusedVertexNumbersAreNotCounted) {
  const Topology t = topologyOf(Triangles{{100, 7, 5000}});
  EXPECT_EQ(t.vertices, 3);
  EXPECT_EQ(t.borderEdges.size(), 3u);
}

}  // namespace
}  // namespace sinew
