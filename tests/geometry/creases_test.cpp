// tests/geometry/creases_test.cpp: fans and their normals, on known shapes and compared with a slow search.

#include "core/geometry/normals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/geometry/weld.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Given vertices, all on one bone and with one texture coordinate.
ControlMesh meshOf(const std::vector<glm::vec3>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  TriangleSoup soup;
  soup.positions = points;
  soup.uvs.assign(points.size(), glm::vec2(0.0f));
  soup.influences.assign(points.size(), Influence{0, 1.0f});
  for (std::size_t v = 0; v <= points.size(); ++v) soup.influenceBegin.push_back(static_cast<int>(v));
  soup.triangles = triangles;
  soup.materials.assign(triangles.size(), 0);
  return weld(soup, 1e-6f);
}

/// Closed prism along y over a regular polygon; its caps are fans of triangles about their first corner.
ControlMesh prism(std::uint32_t sides) {
  std::vector<glm::vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    for (const float y : {0.0f, 2.0f}) points.emplace_back(std::sin(angle), y, std::cos(angle));
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = 2 * ((i + 1) % sides);
    triangles.push_back({a, b, b + 1});
    triangles.push_back({a, b + 1, a + 1});
    if (i < 1 || i + 1 >= sides) continue;
    triangles.push_back({0, b, a});
    triangles.push_back({1, a + 1, b + 1});
  }
  return meshOf(points, triangles);
}

/// Sheet of n x n quads over the square, with random heights and positions.
ControlMesh shakenSheet(int n, float height, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> shake(-1.0f, 1.0f);
  std::vector<glm::vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      points.emplace_back(static_cast<float>(i) + 0.3f * shake(random), static_cast<float>(j) + 0.3f * shake(random),
                          height * shake(random));
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (n + 1) + i);
      const auto up = static_cast<std::uint32_t>(n + 1);
      triangles.push_back({a, a + 1, a + up + 1});
      triangles.push_back({a, a + up + 1, a + up});
    }
  }
  return meshOf(points, triangles);
}

glm::dvec3 faceNormal(const ControlMesh& mesh, std::size_t triangle) {
  const auto [a, b, c] = mesh.triangles[triangle].vertices;
  const glm::dvec3 p(mesh.positions[at(a)]);
  return glm::normalize(glm::cross(glm::dvec3(mesh.positions[at(b)]) - p, glm::dvec3(mesh.positions[at(c)]) - p));
}

/// Shading normal of a corner.
glm::vec3 cornerNormal(const ControlMesh& mesh, std::size_t triangle, std::size_t corner) {
  const Wedge& wedge = mesh.wedges[at(mesh.triangles[triangle].wedges[corner])];
  return wedge.creased ? wedge.normal : mesh.normals[at(wedge.vertex)];
}

void expectSameGeometry(const ControlMesh& a, const ControlMesh& b) {
  EXPECT_TRUE(test::sameBytes(a.positions, b.positions));
  EXPECT_TRUE(test::sameBytes(a.normals, b.normals));
  EXPECT_EQ(a.influenceBegin, b.influenceBegin);
  ASSERT_EQ(a.edges.size(), b.edges.size());
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (std::size_t t = 0; t < a.triangles.size(); ++t) {
    ASSERT_EQ(a.triangles[t].vertices, b.triangles[t].vertices);
    ASSERT_EQ(a.triangles[t].edges, b.triangles[t].edges);
    for (std::size_t i = 0; i < 3; ++i) {
      const Wedge& was = a.wedges[at(a.triangles[t].wedges[i])];
      const Wedge& is = b.wedges[at(b.triangles[t].wedges[i])];
      ASSERT_EQ(was.vertex, is.vertex);
      ASSERT_EQ(was.uv, is.uv);
    }
  }
}

TEST(Creases, EveryCubeCornerIsSplitIntoThree) {
  const ControlMesh cube = test::makeCube()->mesh;
  ASSERT_EQ(cube.wedges.size(), 8u);
  for (const float degrees : {0.0f, 30.0f, 89.0f}) {
    const ControlMesh sharp = creased(cube, degrees);
    expectSameGeometry(cube, sharp);
    EXPECT_EQ(sharp.wedges.size(), 24u) << degrees;
    for (std::size_t t = 0; t < 12; ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_LT(glm::distance(glm::dvec3(cornerNormal(sharp, t, i)), faceNormal(cube, t)), 1e-6);
      }
    }
  }
  for (const float degrees : {90.0f, 120.0f, kNoCreases}) {
    EXPECT_FALSE(hasCreases(creased(cube, degrees))) << degrees;
    EXPECT_EQ(creased(cube, degrees).wedges.size(), 8u) << degrees;
  }
}

TEST(Creases, CylindersAreSplitOnlyAtTheirCaps) {
  const ControlMesh round = prism(24);  // 15 degrees from side to side
  const ControlMesh sharp = creased(round, 40.0f);
  expectSameGeometry(round, sharp);
  EXPECT_EQ(sharp.wedges.size(), 2 * round.positions.size());
  for (std::size_t t = 0; t < sharp.triangles.size(); ++t) {
    const glm::dvec3 face = faceNormal(sharp, t);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3 p = sharp.positions[at(sharp.triangles[t].vertices[i])];
      const bool cap = std::abs(face.y) > 0.5;
      const glm::vec3 expected = cap ? glm::vec3(0, face.y > 0 ? 1 : -1, 0) : glm::vec3(p.x, 0, p.z);
      ASSERT_LT(glm::distance(cornerNormal(sharp, t, i), expected), 1e-5f) << t;
    }
  }
  EXPECT_EQ(creased(round, 14.9f).wedges.size(), 3 * round.positions.size()) << "sides apart, caps whole";
  EXPECT_EQ(creased(round, 15.0f).wedges.size(), 2 * round.positions.size()) << "as sharp as the angle is no crease";
}

TEST(Creases, RoundMeshesAreUnchanged) {
  for (const auto& character : {test::makeLimb(), test::makeStrip()}) {
    const ControlMesh same = creased(character->mesh, 60.0f);
    expectSameGeometry(character->mesh, same);
    EXPECT_FALSE(hasCreases(same)) << character->name;
    EXPECT_EQ(same.wedges.size(), character->mesh.wedges.size());
  }
}

TEST(Creases, CreaseEndingInTheMeshDoesNotSplitItsEnd) {
  // A fold from the left border to the middle; right of it the sheet is one smooth fan.
  const ControlMesh fold =
      meshOf({{0, 0, 0}, {-1, 0, 0}, {-0.3f, -1, -1}, {-0.3f, 1, -1}, {1, -1, -0.3f}, {1, 1, -0.3f}},
             {{0, 1, 2}, {0, 3, 1}, {0, 2, 4}, {0, 4, 5}, {0, 5, 3}});
  const ControlMesh sharp = creased(fold, 75.0f);
  ASSERT_TRUE(hasCreases(sharp));
  for (const Wedge& wedge : sharp.wedges) EXPECT_EQ(wedge.creased, wedge.vertex == 1) << wedge.vertex;
}

TEST(Creases, DegenerateTrianglesFollowTheirLongestEdge) {
  // Two halves of a square; one has a corner on their common diagonal, and a sliver closes the gap.
  const auto square = [](float lift) {
    return meshOf({{0, 0, 0}, {2, 2, 0}, {1, 1, 0}, {2, 0, lift}, {0, 2, 0}},
                  {{0, 3, 1}, {0, 1, 2}, {0, 2, 4}, {2, 1, 4}});
  };
  ASSERT_EQ(square(0.0f).triangles.size(), 4u);
  EXPECT_FALSE(hasCreases(creased(square(0.0f), 1.0f)));
  const ControlMesh folded = creased(square(1.0f), 20.0f);
  EXPECT_LT(glm::distance(glm::dvec3(cornerNormal(folded, 0, 0)), faceNormal(folded, 0)), 1e-6);
  EXPECT_LT(glm::distance(glm::dvec3(cornerNormal(folded, 2, 0)), faceNormal(folded, 2)), 1e-6);
  EXPECT_EQ(folded.triangles[0].wedges[0], folded.triangles[1].wedges[0]);
}

TEST(Creases, NonManifoldEdgesJoinSmoothNeighbors) {
  // A floor of two halves with a wall on their common edge.
  const ControlMesh wall =
      meshOf({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  ASSERT_EQ(wall.edges[0].triangleCount, 3);
  const ControlMesh sharp = creased(wall, 30.0f);
  EXPECT_EQ(sharp.triangles[0].wedges[0], sharp.triangles[1].wedges[1]);
  EXPECT_NE(sharp.triangles[0].wedges[0], sharp.triangles[2].wedges[0]);
  EXPECT_LT(glm::distance(cornerNormal(sharp, 0, 0), glm::vec3(0, 0, 1)), 1e-6f);
  EXPECT_LT(glm::distance(cornerNormal(sharp, 2, 0), glm::vec3(1, 0, 0)), 1e-6f);
}

TEST(Creases, SeamsAndCreasesSplitTogether) {
  const auto tube = test::makeTube();
  const ControlMesh sharp = creased(tube->mesh, 35.0f);
  expectSameGeometry(tube->mesh, sharp);
  ASSERT_TRUE(hasCreases(sharp));
  int next = 0;
  std::set<std::array<float, 6>> seen;
  for (const ControlTriangle& triangle : sharp.triangles) {
    for (const int wedge : triangle.wedges) {
      EXPECT_LE(wedge, next) << "numbered by first use";
      if (wedge < next) continue;
      ++next;
      const Wedge& w = sharp.wedges[at(wedge)];
      const glm::vec3 n = w.creased ? w.normal : glm::vec3(0.0f);
      EXPECT_TRUE(seen.insert({static_cast<float>(w.vertex), w.uv.x, w.uv.y, n.x, n.y, n.z}).second) << "a wedge twice";
    }
  }
  EXPECT_EQ(next, static_cast<int>(sharp.wedges.size()));
}

/// Joins corners of each vertex by trying all pairs of faces until nothing changes.
std::map<std::array<std::size_t, 2>, std::size_t> slowFans(const ControlMesh& mesh, double degrees) {
  std::map<std::array<std::size_t, 2>, std::size_t> fan;  // (triangle, vertex) -> smallest triangle of its fan
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int v : mesh.triangles[t].vertices) fan[{t, at(v)}] = t;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t s = 0; s < mesh.triangles.size(); ++s) {
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::vector<int> shared;
        for (const int v : mesh.triangles[s].vertices) {
          if (std::ranges::count(mesh.triangles[t].vertices, v) > 0) shared.push_back(v);
        }
        const double cosine = glm::dot(faceNormal(mesh, s), faceNormal(mesh, t));
        const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
        if (s == t || shared.size() != 2 || angle > degrees) continue;
        for (const int v : shared) {
          std::size_t& a = fan[{s, at(v)}];
          std::size_t& b = fan[{t, at(v)}];
          changed = changed || a != b;
          a = b = std::min(a, b);
        }
      }
    }
  }
  return fan;
}

TEST(Creases, RandomSheetsMatchASlowSearch) {
  int creases = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const ControlMesh mesh = shakenSheet(4, 0.2f + 0.1f * static_cast<float>(seed % 6), seed);
    const float degrees = 15.0f + 10.0f * static_cast<float>(seed % 7);
    const ControlMesh sharp = creased(mesh, degrees);
    const auto fan = slowFans(mesh, static_cast<double>(degrees));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      std::map<std::size_t, glm::dvec3> sums;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& c = mesh.triangles[t].vertices;
        const auto i = at(static_cast<int>(std::ranges::find(c, static_cast<int>(v)) - c.begin()));
        if (i == 3) continue;
        const glm::dvec3 p(mesh.positions[v]);
        const glm::dvec3 a = glm::normalize(glm::dvec3(mesh.positions[at(c[(i + 1) % 3])]) - p);
        const glm::dvec3 b = glm::normalize(glm::dvec3(mesh.positions[at(c[(i + 2) % 3])]) - p);
        glm::dvec3& sum = sums.try_emplace(fan.at({t, v}), glm::dvec3(0.0)).first->second;
        sum += std::acos(glm::dot(a, b)) * faceNormal(mesh, t);
      }
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
          if (at(mesh.triangles[t].vertices[i]) != v) continue;
          const Wedge& wedge = sharp.wedges[at(sharp.triangles[t].wedges[i])];
          ASSERT_EQ(wedge.creased, sums.size() > 1) << "seed " << seed << ", vertex " << v;
          const glm::dvec3 expected = glm::normalize(sums.at(fan.at({t, v})));
          ASSERT_LT(glm::distance(glm::dvec3(cornerNormal(sharp, t, i)), expected), 1e-5) << "seed " << seed;
          creases += wedge.creased ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(creases, 200);
}

TEST(Creases, CrumpledMeshesGiveRepeatableUnitNormals) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const ControlMesh mesh = shakenSheet(6, seed % 3 == 0 ? 1e-9f : 4.0f, seed);
    for (const float degrees : {0.0f, 1e-6f, 50.0f, 179.9f}) {
      const ControlMesh a = creased(mesh, degrees);
      const ControlMesh b = creased(mesh, degrees);
      std::vector<glm::vec3> normals;
      for (const Wedge& wedge : a.wedges) normals.push_back(wedge.normal);
      EXPECT_TRUE(test::allUnit(normals)) << seed;
      ASSERT_EQ(a.wedges.size(), b.wedges.size());
      for (std::size_t w = 0; w < a.wedges.size(); ++w) ASSERT_EQ(a.wedges[w].normal, b.wedges[w].normal);
    }
  }
}

TEST(Creases, KeepTheColorOfEveryCorner) {
  ControlMesh mesh = prism(6);
  for (std::size_t w = 0; w < mesh.wedges.size(); ++w) mesh.wedges[w].color.r = 0.01f * static_cast<float>(w);
  const ControlMesh sharp = creased(mesh, 30.0f);
  ASSERT_GT(sharp.wedges.size(), mesh.wedges.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(sharp.wedges[at(sharp.triangles[t].wedges[i])].color,
                mesh.wedges[at(mesh.triangles[t].wedges[i])].color);
    }
  }
}

}  // namespace
}  // namespace sinew
