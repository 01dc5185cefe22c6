// tests/surface/projection/rise_directions_test.cpp: rise directions spread where normals converge, and equal the
// normals elsewhere.

#include "core/surface/projection/rise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/sheets.h"

namespace sinew::test {
namespace {

constexpr float kRise = 0.1f;

ControlMesh groove(float slope) {
  const Sheet sheet = sheetOf(100, [=](float x, float) { return slope * std::abs(x); });
  return meshOf(sheet.positions, sheet.triangles);
}

/// Triangles that are inverted once every vertex is lifted.
int turnedTriangles(const ControlMesh& mesh, const std::vector<glm::vec3>& directions, float lift) {
  int turned = 0;
  for (const ControlTriangle& triangle : mesh.triangles) {
    const auto face = [&](float s) {
      std::array<glm::vec3, 3> at{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto v = static_cast<std::size_t>(triangle.vertices[i]);
        at[i] = mesh.positions[v] + s * directions[v];
      }
      return glm::cross(at[1] - at[0], at[2] - at[0]);
    };
    turned += glm::dot(face(lift), face(0.0f)) < 0.0f ? 1 : 0;
  }
  return turned;
}

/// Largest difference between the directions at the two ends of an edge.
float widest(const ControlMesh& mesh, const std::vector<glm::vec3>& directions) {
  float out = 0.0f;
  for (const Edge& edge : mesh.edges) {
    out = std::max(out, glm::distance(directions[static_cast<std::size_t>(edge.vertices[0])],
                                      directions[static_cast<std::size_t>(edge.vertices[1])]));
  }
  return out;
}

TEST(RiseDirections, EqualTheNormalsOfAConvexBody) {
  const ControlMesh mesh = sphere(12, 9);
  EXPECT_TRUE(sameBytes(riseDirections(mesh, kRise), mesh.normals));
}

TEST(RiseDirections, LetTheSkinRiseInAGroove) {
  const ControlMesh mesh = groove(1.0f);
  const std::vector<glm::vec3> directions = riseDirections(mesh, kRise);
  EXPECT_LT(widest(mesh, directions), 0.5f * widest(mesh, mesh.normals));
  EXPECT_GT(turnedTriangles(mesh, mesh.normals, 0.5f * kRise), 0) << "normals would do as well";
  EXPECT_EQ(turnedTriangles(mesh, directions, 0.5f * kRise), 0);
  EXPECT_TRUE(allUnit(directions));
}

TEST(RiseDirections, EqualTheNormalsFarFromAGroove) {
  const ControlMesh mesh = groove(1.0f);
  const std::vector<glm::vec3> directions = riseDirections(mesh, kRise);
  int far = 0;
  int changed = 0;
  for (std::size_t v = 0; v < directions.size(); ++v) {
    const bool same = sameBits(directions[v], mesh.normals[v]);
    changed += same ? 0 : 1;
    if (std::abs(mesh.positions[v].x) < 0.6f) continue;  // Each round extends one edge of 0.02 further.
    ++far;
    // On the flank normals are parallel up to rounding, which must not count as growing convergence.
    EXPECT_LT(glm::distance(directions[v], mesh.normals[v]), 1e-5f) << v;
  }
  EXPECT_GT(far, 100);
  EXPECT_GT(changed, 20);
}

// Edges are a tenth of the rise: neighbors pulling with their full weight would make directions oscillate.
TEST(RiseDirections, VaryEvenlyAcrossADenseValley) {
  const Sheet sheet = sheetOf(200, [](float x, float) { return std::sqrt(x * x + 0.002f); });
  const ControlMesh mesh = meshOf(sheet.positions, sheet.triangles);
  const std::vector<glm::vec3> directions = riseDirections(mesh, kRise);
  std::vector<std::pair<float, float>> section;  // x, and how far the direction leans along it.
  for (std::size_t v = 0; v < directions.size(); ++v) {
    if (std::abs(mesh.positions[v].y) < 1e-5f) section.emplace_back(mesh.positions[v].x, directions[v].x);
  }
  std::ranges::sort(section);
  ASSERT_EQ(section.size(), 201U);
  float farthest = 0.0f;
  for (std::size_t i = 1; i + 1 < section.size(); ++i) {
    const float between = 0.5f * (section[i - 1].second + section[i + 1].second);
    farthest = std::max(farthest, std::abs(section[i].second - between));
  }
  EXPECT_LT(farthest, 0.01f) << "from the mean of its neighbors";
  EXPECT_LT(widest(mesh, directions), 0.7f * widest(mesh, mesh.normals));
}

TEST(RiseDirections, StayWithin60DegreesOfTheNormal) {
  Random random(5);
  float least = 1.0f;
  for (const float roughness : {0.02f, 0.1f, 0.4f}) {
    const Sheet sheet = sheetOf(20, [&](float, float) { return random.uniform(-roughness, roughness); });
    const ControlMesh mesh = meshOf(sheet.positions, sheet.triangles);
    const std::vector<glm::vec3> directions = riseDirections(mesh, 10.0f * kRise);
    EXPECT_TRUE(allUnit(directions));
    for (std::size_t v = 0; v < directions.size(); ++v) {
      const float cosine = glm::dot(directions[v], mesh.normals[v]);
      least = std::min(least, cosine);
      EXPECT_GE(cosine, 0.5f - 1e-5f) << v;
    }
  }
  EXPECT_LT(least, 0.51f) << "no direction came near the limit";
}

TEST(RiseDirections, AreMirroredOnAMirroredMesh) {
  const auto height = [](float x, float y) { return std::abs(x) + 0.3f * std::sin(7.0f * y) * x * x; };
  const Sheet sheet = sheetOf(20, height);
  const ControlMesh mesh = meshOf(sheet.positions, sheet.triangles);
  const std::vector<glm::vec3> directions = riseDirections(mesh, kRise);
  int pairs = 0;
  for (std::size_t v = 0; v < directions.size(); ++v) {
    for (std::size_t w = 0; w < directions.size(); ++w) {
      const glm::vec3 mirrored(-mesh.positions[w].x, mesh.positions[w].y, mesh.positions[w].z);
      if (glm::distance(mirrored, mesh.positions[v]) > 1e-5f) continue;
      ++pairs;
      const glm::vec3 direction(-directions[w].x, directions[w].y, directions[w].z);
      EXPECT_LT(glm::distance(direction, directions[v]), 1e-5f) << v;
    }
  }
  EXPECT_EQ(pairs, static_cast<int>(directions.size()));
}

TEST(RiseDirections, DoNotDependOnTheOrderOfTriangles) {
  const Sheet sheet = sheetOf(20, [](float x, float y) { return std::abs(x + 0.3f * y); });
  const ControlMesh mesh = meshOf(sheet.positions, sheet.triangles);
  ControlMesh reversed = mesh;
  std::ranges::reverse(reversed.triangles);
  std::ranges::reverse(reversed.edges);
  const std::vector<glm::vec3> a = riseDirections(mesh, kRise);
  const std::vector<glm::vec3> b = riseDirections(reversed, kRise);
  EXPECT_FALSE(sameBytes(a, mesh.normals));
  for (std::size_t v = 0; v < a.size(); ++v) EXPECT_LT(glm::distance(a[v], b[v]), 1e-5f) << v;
}

}  // namespace
}  // namespace sinew::test
