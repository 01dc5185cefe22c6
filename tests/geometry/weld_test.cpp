// tests/geometry/weld_test.cpp: welding of split meshes.

#include "core/geometry/weld.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/geometry/soups.h"
#include "tests/support/euler_characteristic.h"

namespace sinew {
namespace {

constexpr float kTolerance = 1e-6f;

/// The same surface with corners randomly split into separate vertices, in random order, displaced by at most `jitter`.
TriangleSoup splitAtRandom(const TriangleSoup& soup, unsigned seed, float jitter) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> offset(-jitter, jitter);
  std::vector<std::pair<std::uint32_t, glm::vec3>> vertices;  // source, offset
  std::vector<std::array<std::uint32_t, 3>> triangles = soup.triangles;
  std::map<std::uint32_t, std::uint32_t> shared;
  for (auto& triangle : triangles) {
    for (std::uint32_t& corner : triangle) {
      const bool split = random() % 2 == 0;
      const auto known = shared.find(corner);
      if (!split && known != shared.end()) {
        corner = known->second;
        continue;
      }
      vertices.emplace_back(corner, glm::vec3(offset(random), offset(random), offset(random)));
      if (!split) shared[corner] = static_cast<std::uint32_t>(vertices.size() - 1);
      corner = static_cast<std::uint32_t>(vertices.size() - 1);
    }
  }
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::shuffle(order, random);
  std::vector<std::uint32_t> placeOf(order.size());
  TriangleSoup result;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    const auto& [source, moved] = vertices[order[i]];
    placeOf[order[i]] = i;
    addVertex(result, soup.positions[source] + moved, soup.uvs[source], influencesOf(soup, source));
  }
  for (const auto& t : triangles) addTriangle(result, placeOf[t[0]], placeOf[t[1]], placeOf[t[2]]);
  return result;
}

TEST(Weld, AnySplittingGivesTheSameGeometry) {
  const TriangleSoup whole = torus(17, 9);
  const ControlMesh expected = weld(whole, kTolerance);
  EXPECT_EQ(expected.positions.size(), 17u * 9u);
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const ControlMesh mesh = weld(splitAtRandom(whole, seed, 0.0f), kTolerance);
    // Vertices are numbered by first use in triangle order, so that splitting leaves no trace.
    EXPECT_EQ(mesh.positions, expected.positions) << seed;
    ASSERT_EQ(mesh.triangles.size(), expected.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      EXPECT_EQ(mesh.triangles[t].vertices, expected.triangles[t].vertices);
      EXPECT_EQ(mesh.triangles[t].wedges, expected.triangles[t].wedges);
      EXPECT_EQ(mesh.triangles[t].edges, expected.triangles[t].edges);
    }
    EXPECT_EQ(mesh.normals, expected.normals);
    EXPECT_TRUE(topologyOf(mesh).closed());
  }
}

TEST(Weld, NoiseBelowTheToleranceStaysClosed) {
  const TriangleSoup whole = torus(23, 12);
  for (unsigned seed = 1; seed <= 40; ++seed) {
    // Offsets of up to 0.25 along each axis: any two copies lie within 0.87 tolerances.
    const ControlMesh mesh = weld(splitAtRandom(whole, seed, 0.25f * 1e-4f), 1e-4f);
    const Topology topology = topologyOf(mesh);
    EXPECT_TRUE(topology.closed()) << seed;
    EXPECT_EQ(eulerCharacteristic(topology), 0);
    EXPECT_EQ(mesh.positions.size(), 23u * 12u);
    EXPECT_EQ(mesh.trianglesDropped, 0);
  }
}

TEST(Weld, WeldingTwiceChangesNothing) {
  const ControlMesh once = weld(splitAtRandom(torus(11, 7), 5, 0.2f * 1e-4f), 1e-4f);
  TriangleSoup again;
  for (const Wedge& wedge : once.wedges) {
    const auto influences = once.influencesOf(wedge.vertex);
    addVertex(again, once.positions[static_cast<std::size_t>(wedge.vertex)], wedge.uv,
              {influences.begin(), influences.end()});
  }
  for (const ControlTriangle& t : once.triangles) {
    addTriangle(again, static_cast<std::uint32_t>(t.wedges[0]), static_cast<std::uint32_t>(t.wedges[1]),
                static_cast<std::uint32_t>(t.wedges[2]));
  }
  const ControlMesh twice = weld(again, 1e-4f);
  EXPECT_EQ(twice.positions, once.positions);
  EXPECT_EQ(twice.wedges.size(), once.wedges.size());
  EXPECT_EQ(twice.edges.size(), once.edges.size());
  EXPECT_EQ(twice.trianglesDropped, 0);
}

TEST(Weld, EdgesAgreeWithTheTriangles) {
  const ControlMesh mesh = weld(splitAtRandom(torus(9, 6), 3, 0.0f), kTolerance);
  std::vector<int> uses(mesh.edges.size(), 0);
  int next = 0;
  for (const ControlTriangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge& edge = mesh.edges[static_cast<std::size_t>(t.edges[i])];
      const int a = t.vertices[i];
      const int b = t.vertices[(i + 1) % 3];
      EXPECT_EQ(edge.vertices, (std::array{std::min(a, b), std::max(a, b)}));
      EXPECT_LE(t.edges[i], next) << "edges are numbered by first use";
      next = std::max(next, t.edges[i] + 1);
      ++uses[static_cast<std::size_t>(t.edges[i])];
    }
  }
  for (std::size_t e = 0; e < uses.size(); ++e) EXPECT_EQ(uses[e], mesh.edges[e].triangleCount);
}

TEST(Weld, DifferentBindingsKeepVerticesApart) {
  EXPECT_EQ(weld(hinge({{0, 1.0f}}, {{0, 1.0f}}), kTolerance).positions.size(), 4u);
  EXPECT_EQ(weld(hinge({{0, 1.0f}}, {{1, 1.0f}}), kTolerance).positions.size(), 6u);
  EXPECT_EQ(weld(hinge({{0, 0.5f}, {1, 0.5f}}, {{0, 0.6f}, {1, 0.4f}}), kTolerance).positions.size(), 6u);
  EXPECT_EQ(weld(hinge({{0, 0.5f}, {1, 0.5f}}, {{0, 0.50005f}, {1, 0.49995f}}), kTolerance).positions.size(), 4u);
}

TEST(Weld, SeamsSplitWedgesButNotVertices) {
  const ControlMesh mesh = weld(hinge({{0, 1.0f}}, {{0, 1.0f}}, {0.5f, 0.25f}), kTolerance);
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.wedges.size(), 6u);
  EXPECT_EQ(mesh.edges.size(), 5u);
  for (const ControlTriangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(mesh.wedges[static_cast<std::size_t>(t.wedges[i])].vertex, t.vertices[i]);
  }
}

TEST(Weld, DegenerateTrianglesAreCountedAndTheirVerticesRemoved) {
  TriangleSoup soup = hinge({{0, 1.0f}}, {{0, 1.0f}});
  addVertex(soup, {7, 7, 7});
  addVertex(soup, {7, 7, 7 + 2e-7f});
  addVertex(soup, {9, 9, 9});
  addTriangle(soup, 0, 1, 1);
  addTriangle(soup, 1, 3, 0);  // 1 and 3 weld
  addTriangle(soup, 6, 7, 8);  // 6 and 7 weld
  const ControlMesh mesh = weld(soup, 1e-6f);
  EXPECT_EQ(mesh.trianglesDropped, 3);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions.size(), 4u);
}

TEST(Weld, EveryInputTriangleIsMappedToItsResult) {
  TriangleSoup soup = splitAtRandom(torus(12, 9), 5, 0.0f);
  const auto corner = soup.triangles[7];
  soup.triangles.insert(soup.triangles.begin() + 4, {corner[0], corner[0], corner[2]});
  soup.materials.insert(soup.materials.begin() + 4, 0);
  const ControlMesh mesh = weld(soup, 1e-6f);
  const std::vector<int> welded = weldedTriangles(soup, 1e-6f);
  ASSERT_EQ(welded.size(), soup.triangles.size());
  EXPECT_EQ(welded[4], -1);
  EXPECT_EQ(std::ranges::count(welded, -1), mesh.trianglesDropped);
  for (std::size_t t = 0; t < welded.size(); ++t) {
    if (welded[t] < 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const int vertex = mesh.triangles[static_cast<std::size_t>(welded[t])].vertices[i];
      EXPECT_EQ(mesh.positions[static_cast<std::size_t>(vertex)], soup.positions[soup.triangles[t][i]]);
    }
  }
}

TEST(Weld, SliversAreKept) {
  TriangleSoup soup;
  for (const float x : {0.0f, 1.0f, 2.0f}) addVertex(soup, {x, 0, 0});
  addTriangle(soup, 0, 1, 2);
  const ControlMesh mesh = weld(soup, kTolerance);
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.trianglesDropped, 0);
}

TEST(Weld, MinusZeroEqualsZero) {
  TriangleSoup soup = hinge({{0, 1.0f}}, {{0, 1.0f}});
  soup.positions[3].z = -0.0f;
  soup.uvs[4] = {-0.0f, 0.0f};
  const ControlMesh mesh = weld(soup, 0.0f);
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.wedges.size(), 4u);
}

TEST(Weld, EmptySoupGivesAnEmptyMesh) {
  TriangleSoup soup;
  soup.influenceBegin.push_back(0);
  const ControlMesh mesh = weld(soup, kTolerance);
  EXPECT_TRUE(mesh.triangles.empty());
  EXPECT_TRUE(mesh.positions.empty());
}

/// A hundred thousand vertices in one place, equal or each with its own binding: a quadratic welder would take forever.
TEST(Weld, ManyCoincidentVerticesAreFast) {
  for (const bool alike : {true, false}) {
    TriangleSoup soup;
    constexpr std::uint32_t kTriangles = 100'000;
    addVertex(soup, {1, 0, 0});
    addVertex(soup, {0, 1, 0});
    for (std::uint32_t t = 0; t < kTriangles; ++t) {
      const float w = alike ? 0.25f : 0.1f + 0.8f * static_cast<float>(t) / kTriangles;
      addVertex(soup, {0, 0, 0}, {}, {{1, w}, {2 + static_cast<int>(t % (alike ? 1 : 97)), 1.0f - w}});
      addTriangle(soup, 0, 1, t + 2);
    }
    const ControlMesh mesh = weld(soup, kTolerance);
    EXPECT_EQ(mesh.triangles.size(), kTriangles);
    EXPECT_TRUE(alike ? mesh.positions.size() == 3 : mesh.positions.size() > 100) << mesh.positions.size();
  }
}

/// Three sheets of different bones along one edge: no edge of the bound mesh has more than one triangle, but one of the
/// shape does.
TEST(JoinedByPosition, JoinsPartsOfDifferentBones) {
  TriangleSoup soup;
  for (int sheet = 0; sheet < 3; ++sheet) {
    const auto base = static_cast<std::uint32_t>(soup.positions.size());
    const float angle = 2.0f * static_cast<float>(sheet);
    addVertex(soup, {0, 0, 0}, {}, {{sheet, 1.0f}});
    addVertex(soup, {0, 1, 0}, {}, {{sheet, 1.0f}});
    addVertex(soup, {std::cos(angle), 0, std::sin(angle)}, {}, {{sheet, 1.0f}});
    addTriangle(soup, base, base + 1, base + 2);
  }
  const ControlMesh bound = weld(soup, kTolerance);
  EXPECT_EQ(bound.positions.size(), 9u);
  EXPECT_TRUE(topologyOf(bound).nonManifoldEdges.empty());
  const ControlMesh joined = joinedByPosition(bound, kTolerance);
  EXPECT_EQ(joined.positions.size(), 5u);
  EXPECT_EQ(topologyOf(joined).nonManifoldEdges.size(), 1u);
}

TEST(JoinedByPosition, WeldedMeshIsUnchanged) {
  const ControlMesh mesh = weld(torus(7, 9), kTolerance);
  const ControlMesh joined = joinedByPosition(mesh, kTolerance);
  EXPECT_EQ(joined.positions, mesh.positions);
  EXPECT_EQ(joined.triangles.size(), mesh.triangles.size());
}

// Two triangles on one edge, with separate vertices: the number of wedges depends only on the colors there.
TEST(Weld, ColorsSplitOnlyWedges) {
  TriangleSoup soup;
  for (const glm::vec3& p : {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0),
                             glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)}) {
    addVertex(soup, p);
  }
  addTriangle(soup, 0, 1, 2);
  addTriangle(soup, 3, 4, 5);
  const ControlMesh plain = weld(soup, kTolerance);
  EXPECT_EQ(plain.wedges.size(), 4u);
  EXPECT_FALSE(hasColors(plain));
  soup.colors.assign(6, glm::vec4(1.0f));
  EXPECT_EQ(weld(soup, kTolerance).wedges.size(), 4u);
  EXPECT_FALSE(hasColors(weld(soup, kTolerance))) << "white is no color";
  soup.colors.assign(6, glm::vec4(0.2f, 0.4f, 0.6f, 1.0f));
  EXPECT_EQ(weld(soup, kTolerance).wedges.size(), 4u);
  for (int channel = 0; channel < 4; ++channel) {
    TriangleSoup split = soup;
    split.colors[3][channel] = 0.5f;
    const ControlMesh mesh = weld(split, kTolerance);
    EXPECT_TRUE(hasColors(mesh));
    EXPECT_EQ(mesh.positions, plain.positions);
    EXPECT_EQ(mesh.edges.size(), plain.edges.size());
    ASSERT_EQ(mesh.wedges.size(), 5u) << channel;
    for (std::size_t t = 0; t < 2; ++t) {
      EXPECT_EQ(mesh.triangles[t].vertices, plain.triangles[t].vertices);
      for (std::size_t i = 0; i < 3; ++i) {
        const Wedge& wedge = mesh.wedges[static_cast<std::size_t>(mesh.triangles[t].wedges[i])];
        EXPECT_EQ(wedge.color, split.colors[split.triangles[t][i]]);
        EXPECT_EQ(wedge.vertex, mesh.triangles[t].vertices[i]);
      }
    }
  }
}

TEST(Weld, VerticesOfTwoRoundedPiecesMeetWithinTheRounding) {
  const auto count = [](const std::vector<Influence>& left, const std::vector<Influence>& right) {
    TriangleSoup soup = hinge(left, right);
    soup.pieces = {{0.0f, 0.01f}, {0.0f, 0.01f}};
    soup.pieceOf = {0, 0, 0, 1, 1, 1};
    return weld(soup, kTolerance).positions.size();
  };
  EXPECT_EQ(count({{0, 0.5f}, {1, 0.5f}}, {{0, 0.505f}, {1, 0.495f}}), 4u);
  EXPECT_EQ(count({{0, 0.5f}, {1, 0.5f}}, {{0, 0.6f}, {1, 0.4f}}), 6u);
  EXPECT_EQ(count({{0, 1.0f}}, {{0, 0.995f}, {1, 0.005f}}), 4u) << "a small weight may have been rounded to none";
  EXPECT_EQ(count({{0, 1.0f}}, {{0, 0.9f}, {1, 0.1f}}), 6u);
}

}  // namespace
}  // namespace sinew
