// tests/surface/projection/rise_limits_test.cpp: skin surfaces that face each other divide the gap between them, and
// nothing else is limited.

#include "core/surface/projection/rise.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/sheets.h"

namespace sinew::test {
namespace {

/// Two sheets that face each other, the lower one first.
ControlMesh walls(int cells, float gap) {
  Sheet sheet = sheetOf(cells, [](float, float) { return 0.0f; });
  const int count = static_cast<int>(sheet.positions.size());
  const std::vector<std::array<int, 3>> lower = sheet.triangles;
  for (int v = 0; v < count; ++v) sheet.positions.push_back(sheet.positions[static_cast<std::size_t>(v)]);
  for (int v = count; v < 2 * count; ++v) sheet.positions[static_cast<std::size_t>(v)].z = gap;
  for (const auto& t : lower) sheet.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
  return meshOf(sheet.positions, sheet.triangles);
}

TEST(RiseLimits, AreHalfTheGapOfFacingWalls) {
  const ControlMesh mesh = walls(20, 0.3f);
  constexpr float kMost = 0.5f;
  const std::vector<float> inverse = inverseRiseLimits(mesh, mesh.normals, kMost);
  // The facing point is at most a cell of 0.15 kMost to the side, which counts squared.
  const float aside = 0.15f * kMost / 0.3f;
  for (std::size_t v = 0; v < inverse.size(); ++v) {
    EXPECT_GE(1.0f / inverse[v], 0.15f - 1e-5f) << v;
    EXPECT_LE(1.0f / inverse[v], 0.15f * (1.0f + aside * aside)) << v;
  }
}

// Control triangles much larger than the gap: the facing point lies inside one.
TEST(RiseLimits, AccountForTheInteriorOfLargeTriangles) {
  Sheet sheet = sheetOf(2, [](float, float) { return 0.0f; });
  const int count = static_cast<int>(sheet.positions.size());
  sheet.positions.insert(sheet.positions.end(), {{-6.0f, -5.0f, 0.2f}, {6.0f, -5.0f, 0.2f}, {0.0f, 7.0f, 0.2f}});
  sheet.triangles.push_back({count, count + 2, count + 1});
  const ControlMesh mesh = meshOf(sheet.positions, sheet.triangles);
  const std::vector<float> inverse = inverseRiseLimits(mesh, mesh.normals, 2.0f);
  for (int v = 0; v < count; ++v) {
    const float limit = 1.0f / inverse[static_cast<std::size_t>(v)];
    EXPECT_GE(limit, 0.0999f) << v;
    // The large triangle's own corners are 5 or more away: half of |q-p|^2 / 0.4.
    EXPECT_LE(limit, 5.0f) << v;
  }
}

TEST(RiseLimits, DoNotExistOnAConvexBody) {
  const ControlMesh mesh = sphere(12, 9);
  for (const float inverse : inverseRiseLimits(mesh, mesh.normals, 1.0f)) EXPECT_EQ(inverse, 0.0f);
}

TEST(RiseLimits, FadeOutAboveTheMaximum) {
  const auto inverseAt = [](float most) {
    const ControlMesh mesh = walls(4, 0.3f);
    return inverseRiseLimits(mesh, mesh.normals, most).front();
  };
  EXPECT_NEAR(inverseAt(0.15f), 1.0f / 0.15f, 1e-3f);
  EXPECT_GT(inverseAt(0.12f), 0.0f);
  EXPECT_LT(inverseAt(0.12f), 0.9f / 0.15f);
  EXPECT_EQ(inverseAt(0.09f), 0.0f);
}

// A groove with steep sides: no pair of lifted points may pass through each other.
TEST(RiseLimits, KeepLiftedWallsApart) {
  const Sheet sheet = sheetOf(40, [](float x, float) { return 2.0f * std::abs(x); });
  const ControlMesh mesh = meshOf(sheet.positions, sheet.triangles);
  const std::vector<float> inverse = inverseRiseLimits(mesh, mesh.normals, 0.3f);
  int limited = 0;
  for (std::size_t v = 0; v < inverse.size(); ++v) {
    const glm::vec3 lifted = mesh.positions[v] + in_float::limitedRise(0.15f, inverse[v]) * mesh.normals[v];
    limited += inverse[v] > 0.0f ? 1 : 0;
    // The other side of the groove is beyond x = 0.
    EXPECT_GE(lifted.x * mesh.positions[v].x, -1e-6f) << v;
  }
  EXPECT_GT(limited, 100);
}

// Thinning a mesh to one point in many must not lose a wall.
TEST(RiseLimits, DoNotDependOnMeshDensity) {
  const auto middle = [](int cells) {
    const ControlMesh mesh = walls(cells, 0.3f);
    const std::vector<float> inverse = inverseRiseLimits(mesh, mesh.normals, 0.5f);
    return 1.0f / inverse[inverse.size() / 4];
  };
  EXPECT_NEAR(middle(120), middle(10), 0.01f);
}

TEST(RiseLimits, DoNotDependOnTheOrderOfTriangles) {
  const ControlMesh mesh = walls(6, 0.3f);
  ControlMesh reversed = mesh;
  std::ranges::reverse(reversed.triangles);
  EXPECT_EQ(inverseRiseLimits(mesh, mesh.normals, 0.5f), inverseRiseLimits(reversed, mesh.normals, 0.5f));
}

TEST(RiseLimits, CompressHeightsSmoothlyBelowTheLimit) {
  constexpr float kLimit = 0.2f;
  constexpr float kStep = 0.001f;
  float before = 0.0f;
  float slopeBefore = 1.0f;
  for (int i = 1; i <= 2000; ++i) {
    const float s = kStep * static_cast<float>(i);
    const float height = in_float::limitedRise(s, 1.0f / kLimit);
    const float slope = (height - before) / kStep;
    if (s <= 0.5f * kLimit) {
      EXPECT_EQ(height, s);
    }
    EXPECT_LT(height, kLimit);
    EXPECT_GT(slope, 0.0f);
    EXPECT_NEAR(slope, slopeBefore, 0.03f) << "a corner at " << s;
    before = height;
    slopeBefore = slope;
  }
  EXPECT_EQ(in_float::limitedRise(0.7f, 0.0f), 0.7f) << "no limit";
  EXPECT_EQ(in_float::limitedRise(-0.7f, 9.0f), -0.7f) << "inwards";
}

}  // namespace
}  // namespace sinew::test
