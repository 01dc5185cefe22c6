// tests/surface/patches/adaptive_refinement_test.cpp: levels by edge and triangle: closed, tiled, without slivers;
// equal levels give the N-adic refinement bit for bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "core/geometry/weld.h"
#include "core/surface/patches/levels.h"
#include "core/surface/patches/sample_points.h"
#include "core/surface/patches/split_triangle.h"
#include "core/surface/patches/triangulation.h"
#include "sinew/surface/refinement.h"
#include "tests/support/characters/body_with_arms.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/euler_characteristic.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {
namespace {

using Levels = RefinementLevels;
using CharacterPtr = std::shared_ptr<const Character>;

Levels randomLevels(const ControlMesh& mesh, std::mt19937& random, int most) {
  std::uniform_int_distribution<int> level(1, most);
  Levels out;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) out.edges.push_back(static_cast<std::uint8_t>(level(random)));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    out.triangles.push_back(static_cast<std::uint8_t>(level(random)));
  }
  return out;
}

/// Points of edges, each up to .4 of a segment from its even place.
AlignedSplits randomPlaces(const Levels& levels, std::mt19937& random) {
  std::uniform_real_distribution<double> off(-0.4, 0.4);
  AlignedSplits out;
  for (const int level : levels.edges) {
    std::vector<double>& shares = out.edges.emplace_back();
    for (int step = 1; step < level; ++step) shares.push_back((step + off(random)) / level);
  }
  return out;
}

glm::dvec3 flatPoint(const ControlMesh& mesh, const Refinement& refinement, int triangle, int vertex) {
  const glm::dvec3 at = controlCoordinates(mesh, refinement, triangle, vertex);
  glm::dvec3 out(0.0);
  for (int c = 0; c < 3; ++c) {
    const int corner = mesh.triangles[static_cast<std::size_t>(triangle)].vertices[static_cast<std::size_t>(c)];
    out += at[c] * glm::dvec3(mesh.positions[static_cast<std::size_t>(corner)]);
  }
  return out;
}

/// Degrees.
double leastAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto angle = [](const glm::dvec3& at, const glm::dvec3& p, const glm::dvec3& q) {
    const glm::dvec3 u = glm::normalize(p - at);
    const glm::dvec3 v = glm::normalize(q - at);
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)) * 180.0 / 3.14159265358979;
  };
  return std::min({angle(a, b, c), angle(b, c, a), angle(c, a, b)});
}

void expectSame(const Refinement& a, const Refinement& b) {
  EXPECT_EQ(a.vertexCount, b.vertexCount);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.drawTriangles, b.drawTriangles);
  EXPECT_EQ(a.drawVertex, b.drawVertex);
  EXPECT_TRUE(a.drawUv == b.drawUv);
  EXPECT_TRUE(a.inside == b.inside);
}

TEST(AdaptiveRefinement, EqualLevelsGiveTheUniformMesh) {
  for (const CharacterPtr& character : {makeTube(), makeBodyWithArms()}) {
    const ControlMesh& mesh = character->mesh;
    for (int n = 1; n <= 12; ++n) {
      const auto level = static_cast<std::uint8_t>(n);
      const Levels levels{std::vector<std::uint8_t>(mesh.edges.size(), level),
                          std::vector<std::uint8_t>(mesh.triangles.size(), level)};
      const Refinement refinement = refine(mesh, levels);
      EXPECT_TRUE(refinement.isUniform);
      expectSame(refinement, refine(mesh, n));
    }
  }
}

// Each triangle's pieces have its area and orientation, and every side of a piece belongs to two pieces or lies on the
// mesh's border: no cracks, T-joints or overlaps. The Euler characteristic is the control mesh's.
TEST(AdaptiveRefinement, AnyLevelsTileTheMesh) {
  std::mt19937 random(5);
  for (const CharacterPtr& character : {makeTube(), makeBodyWithArms()}) {
    const ControlMesh& mesh = character->mesh;
    const Topology control = topologyOf(mesh);
    for (int round = 0; round < 60; ++round) {
      const Levels levels = randomLevels(mesh, random, round % 2 == 0 ? 16 : 4);
      const bool isEven = round % 3 == 0;
      const Refinement refinement = refine(mesh, levels, isEven ? AlignedSplits{} : randomPlaces(levels, random));
      ASSERT_EQ(refinement.onEdges.empty(), isEven);
      const Topology topology = topologyOf(refinement.triangles);
      ASSERT_EQ(eulerCharacteristic(topology), eulerCharacteristic(control));
      ASSERT_EQ(topology.closed(), control.closed());
      ASSERT_EQ(topology.vertices, refinement.vertexCount);
      std::vector<double> areas(mesh.triangles.size(), 0.0);
      std::vector<glm::dvec3> faces(mesh.triangles.size(), glm::dvec3(0.0));
      for (std::size_t i = 0; i < refinement.triangles.size(); ++i) {
        const int t = refinement.controlOf[i];
        const auto corner = [&](std::size_t c) { return flatPoint(mesh, refinement, t, refinement.triangles[i][c]); };
        const glm::dvec3 face = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        areas[static_cast<std::size_t>(t)] += glm::length(face);
        faces[static_cast<std::size_t>(t)] += face;
      }
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto corner = [&](std::size_t c) {
          return glm::dvec3(mesh.positions[static_cast<std::size_t>(mesh.triangles[t].vertices[c])]);
        };
        const glm::dvec3 whole = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        ASSERT_NEAR(areas[t], glm::length(whole), 1e-6 * glm::length(whole)) << "overlapping or turned pieces";
        ASSERT_LT(glm::length(faces[t] - whole), 1e-6 * glm::length(whole));
      }
    }
  }
}

TEST(AdaptiveRefinement, PointsOfEdgesLieWhereTheyAreAsked) {
  std::mt19937 random(8);
  const CharacterPtr character = makeBodyWithArms();
  const ControlMesh& mesh = character->mesh;
  Levels levels = uniformLevels(mesh, 4);
  AlignedSplits places = randomPlaces(levels, random);
  levels.edges[3] = 5;  // Places of other levels are not used.
  const Refinement refinement = refine(mesh, levels, places);
  EXPECT_FALSE(refinement.isUniform);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int edge : mesh.triangles[t].edges) {
      const auto& [a, b] = mesh.edges[static_cast<std::size_t>(edge)].vertices;
      for (int step = 1; step < refinement.edgeLevel(edge); ++step) {
        const double share =
            edge == 3 ? step / 5.0 : places.edges[static_cast<std::size_t>(edge)][static_cast<std::size_t>(step - 1)];
        const auto point = [&](int v) { return glm::dvec3(mesh.positions[static_cast<std::size_t>(v)]); };
        const glm::dvec3 wanted = point(a) + share * (point(b) - point(a));
        const glm::dvec3 own = flatPoint(mesh, refinement, static_cast<int>(t), refinement.edgeVertex(edge, step));
        ASSERT_LT(glm::distance(own, wanted), 1e-12);
      }
    }
  }
}

TEST(AdaptiveRefinement, DrawnAndRefinedTrianglesAgree) {
  std::mt19937 random(6);
  const CharacterPtr character = makeTube();
  const Refinement refinement = refine(character->mesh, randomLevels(character->mesh, random, 7));
  for (std::size_t i = 0; i < refinement.triangles.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(refinement.drawVertex[refinement.drawTriangles[i][c]], refinement.triangles[i][c]);
    }
    const int t = refinement.controlOf[i];
    EXPECT_GE(static_cast<int>(i), refinement.triangleBegin[static_cast<std::size_t>(t)]);
    EXPECT_LT(static_cast<int>(i), refinement.triangleBegin[static_cast<std::size_t>(t) + 1]);
  }
}

// 10,000 triangles of all shapes with random levels, graded like a mesh's. Thin ones have thin pieces.
TEST(AdaptiveRefinement, GradedLevelsAvoidSlivers) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
  double worst = 180.0;
  int rounds = 0;
  while (rounds < 10'000) {
    std::array<glm::vec3, 3> corners;
    for (glm::vec3& corner : corners) corner = {coordinate(random), coordinate(random), coordinate(random)};
    const double own = leastAngle(corners[0], corners[1], corners[2]);
    if (own < 1.0) continue;
    const double least = own < 18.0 ? own / 6.0 : 3.0;
    ++rounds;
    ControlMesh mesh;
    mesh.positions.assign(corners.begin(), corners.end());
    for (int v = 0; v < 3; ++v) mesh.wedges.push_back({v});
    mesh.edges = {{{0, 1}, 1}, {{1, 2}, 1}, {{0, 2}, 1}};
    mesh.triangles.push_back({{0, 1, 2}, {0, 1, 2}, {0, 1, 2}, 0});
    const Levels levels = LevelGrader(mesh).graded(randomLevels(mesh, random, 12));
    const Refinement refinement = refine(mesh, levels);
    for (const auto& t : refinement.triangles) {
      const double angle = leastAngle(flatPoint(mesh, refinement, 0, t[0]), flatPoint(mesh, refinement, 0, t[1]),
                                      flatPoint(mesh, refinement, 0, t[2]));
      worst = std::min(worst, angle - least);
      ASSERT_GE(angle, least - 1e-3) << own << " degrees, levels " << int{levels.edges[0]} << ' '
                                     << int{levels.edges[1]} << ' ' << int{levels.edges[2]} << ", inside "
                                     << int{levels.triangles[0]};
    }
  }
  std::printf("least angle beyond the bound: %.2f degrees\n", worst);
}

TEST(AdaptiveRefinement, GradingIsMinimalAndIndependentOfOrder) {
  std::mt19937 random(8);
  const CharacterPtr character = makeBodyWithArms();
  const LevelGrader grader(character->mesh);
  for (int round = 0; round < 20; ++round) {
    const Levels asked = randomLevels(character->mesh, random, 12);
    const Levels graded = grader.graded(asked);
    EXPECT_EQ(grader.graded(graded), graded);
    for (std::size_t e = 0; e < asked.edges.size(); ++e) EXPECT_GE(graded.edges[e], asked.edges[e]);
    for (std::size_t t = 0; t < asked.triangles.size(); ++t) EXPECT_GE(graded.triangles[t], asked.triangles[t]);
  }
  const Levels ones{std::vector<std::uint8_t>(character->mesh.edges.size(), 12),
                    std::vector<std::uint8_t>(character->mesh.triangles.size(), 12)};
  EXPECT_EQ(grader.graded(ones), ones);
}

// A circle's chord at level n is off by r (1 - cos(a / 2n)).
TEST(LevelFit, ArcLevelFollowsItsSagitta) {
  constexpr int kFine = 12;
  constexpr float kAngle = 1.2f;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  for (int i = 0; i <= kFine; ++i) {
    const float a = kAngle * static_cast<float>(i) / kFine;
    normals.emplace_back(std::cos(a), std::sin(a), 0.0f);
    positions.push_back(normals.back());
  }
  for (const float tolerance : {0.2f, 0.05f, 0.02f, 0.01f, 0.004f, 0.002f, 1e-5f}) {
    int expected = kFine;
    for (const int n : {6, 4, 3, 2, 1}) {
      // Samples lie in the middle of a chord if it spans an even number of them.
      const float half = kAngle / static_cast<float>(2 * n);
      const float off = (kFine / n) % 2 == 0 ? 0.0f : kAngle / (2 * kFine);
      if (std::cos(off) - std::cos(half) <= tolerance) expected = n;
    }
    EXPECT_EQ(edgeLevel({positions, normals}, 1, {tolerance, -1.0f}), expected) << tolerance;
  }
  // Normals: at level n they deviate very little, so a loose angle requires no more levels.
  EXPECT_EQ(edgeLevel({positions, normals}, 1, {10.0f, 0.5f}), 1);
}

TEST(LevelFit, SplitsABumpButNotAFlatTriangle) {
  constexpr int kFine = 12;
  std::vector<glm::vec3> positions;
  for (int j = 0; j <= kFine; ++j) {
    for (int k = 0; k <= kFine - j; ++k) positions.emplace_back(static_cast<float>(j), static_cast<float>(k), 0.0f);
  }
  const std::vector<glm::vec3> normals(positions.size(), glm::vec3(0.0f, 0.0f, 1.0f));
  EXPECT_EQ(triangleLevel({positions, normals}, kFine, 1, {0.001f, 0.99f}), 1);
  std::vector<glm::vec3> bumped = positions;
  for (glm::vec3& p : bumped) p.z = p.x == 4.0f && p.y == 4.0f ? 1.0f : 0.0f;
  EXPECT_EQ(triangleLevel({bumped, normals}, kFine, 1, {0.1f, -1.0f}), 12);
  for (glm::vec3& p : bumped) p.z = 0.02f * p.x * p.x;
  const int level = triangleLevel({bumped, normals}, kFine, 1, {0.05f, -1.0f});
  EXPECT_GT(level, 3);
  EXPECT_LT(level, 12);
}

TEST(LevelFit, MisfitIsAboveOneWhereOneFlatPieceDoesNotFit) {
  constexpr int kFine = 6;
  Random random(3);
  int fits = 0;
  int fails = 0;
  for (int round = 0; round < 2000; ++round) {
    const float height = random.uniform(0.0f, 0.05f);
    const float turn = random.uniform(0.0f, 0.3f);
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    for (int j = 0; j <= kFine; ++j) {
      for (int k = 0; k <= kFine - j; ++k) {
        positions.emplace_back(j, k, height * random.uniform(-1.0f, 1.0f));
        normals.push_back(
            glm::normalize(glm::vec3(turn * random.uniform(-1.0f, 1.0f), turn * random.uniform(-1.0f, 1.0f), 1.0f)));
      }
    }
    const FineSamples samples{positions, normals};
    const LevelTolerance tolerance{0.03f, 0.99f, round % 2 == 0 ? 0.0f : 20.0f};
    const float misfit = triangleMisfit(samples, kFine, tolerance);
    const bool isFlat = triangleLevel(samples, kFine, 1, tolerance) == 1;
    (isFlat ? fits : fails) += 1;
    EXPECT_EQ(misfit <= 1.0f, isFlat) << misfit;
    for (std::size_t side = 0; side < 3; ++side) {
      const SideSamples own(samples, kFine, side);
      const float ofEdge = edgeMisfit(own.samples(), tolerance);
      EXPECT_EQ(ofEdge <= 1.0f, edgeLevel(own.samples(), 1, tolerance) == 1) << ofEdge;
    }
  }
  EXPECT_GT(fits, 200);
  EXPECT_GT(fails, 200);
}

TEST(LevelFit, SidesGoFromCornerToCorner) {
  constexpr int kFine = 3;
  std::vector<glm::vec3> positions;
  for (int j = 0; j <= kFine; ++j) {
    for (int k = 0; k <= kFine - j; ++k) positions.emplace_back(kFine - j - k, j, k);
  }
  for (std::size_t side = 0; side < 3; ++side) {
    const SideSamples own({positions, positions}, kFine, side);
    ASSERT_EQ(own.samples().positions.size(), 4u);
    for (int i = 0; i <= kFine; ++i) {
      glm::vec3 expected(0.0f);
      expected[static_cast<int>(side)] = static_cast<float>(kFine - i);
      expected[static_cast<int>((side + 1) % 3)] = static_cast<float>(i);
      EXPECT_EQ(own.samples().positions[toIndex(i)], expected);
    }
  }
}

TEST(SamplePoints, MatchUniformSplits) {
  const CharacterPtr character = makeTube();
  const ControlMesh& mesh = character->mesh;
  const Levels levels{std::vector<std::uint8_t>(mesh.edges.size(), 6),
                      std::vector<std::uint8_t>(mesh.triangles.size(), 6)};
  const Refinement points = samplePoints(mesh, levels);
  const Refinement whole = refine(mesh, 6);
  EXPECT_EQ(points.vertexCount, whole.vertexCount);
  EXPECT_EQ(points.edgeBegin, whole.edgeBegin);
  EXPECT_TRUE(points.inside == whole.inside);
  EXPECT_TRUE(points.triangles.empty());
}

}  // namespace
}  // namespace sinew::test
