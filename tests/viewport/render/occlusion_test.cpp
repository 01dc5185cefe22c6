// tests/viewport/render/occlusion_test.cpp: convex bodies are unoccluded, gaps are not; interpolated values follow the
// barycentrics.
#include "app/viewport/render/occlusion.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/weld.h"
#include "sinew/character/pose.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew::test {
namespace {

/// Adds a ball of triangles.
void addBall(TriangleSoup& soup, const glm::vec3& center, float radius) {
  constexpr int kRows = 16, kColumns = 32;
  const auto first = static_cast<std::uint32_t>(soup.positions.size());
  for (int row = 0; row <= kRows; ++row) {
    for (int column = 0; column <= kColumns; ++column) {
      const float polar = std::numbers::pi_v<float> * static_cast<float>(row) / kRows;
      const float turn = 2.0f * std::numbers::pi_v<float> * static_cast<float>(column % kColumns) / kColumns;
      const float ring = row == 0 || row == kRows ? 0.0f : std::sin(polar);
      const glm::vec3 outwards(ring * std::sin(turn), std::cos(polar), ring * std::cos(turn));
      soup.positions.push_back(center + radius * outwards);
    }
  }
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const std::uint32_t a = first + row * (kColumns + 1) + column, b = a + kColumns + 1;
      soup.triangles.push_back({a, b, a + 1});
      soup.triangles.push_back({a + 1, b, b + 1});
      soup.materials.insert(soup.materials.end(), {0, 0});
    }
  }
}

ControlMesh meshOf(TriangleSoup soup) {
  soup.uvs.assign(soup.positions.size(), glm::vec2(0.0f));
  for (std::size_t i = 0; i <= soup.positions.size(); ++i) soup.influenceBegin.push_back(static_cast<int>(i));
  soup.influences.assign(soup.positions.size(), {0, 1.0f});
  return weld(soup, 1e-6f);
}

TEST(Openness, ConvexBallIsFullyOpen) {
  TriangleSoup soup;
  addBall(soup, {3, 4, 5}, 2.0f);
  const ControlMesh mesh = meshOf(std::move(soup));
  for (const float open : app::bakeOpenness(mesh)) EXPECT_GT(open, 0.97f);
}

TEST(Openness, AdjacentBallsShadeEachOther) {
  for (const float scale : {0.01f, 1.0f, 150.0f}) {
    TriangleSoup soup;
    addBall(soup, scale * glm::vec3(-1.08f, 0, 0), scale);
    addBall(soup, scale * glm::vec3(1.08f, 0, 0), scale);
    const ControlMesh mesh = meshOf(std::move(soup));
    const std::vector<float> open = app::bakeOpenness(mesh);
    float facing = 0.0f, away = 1.0f;
    for (std::size_t i = 0; i < open.size(); ++i) {
      EXPECT_GE(open[i], 0.0f);
      EXPECT_LE(open[i], 1.0f);
      if (std::abs(mesh.positions[i].x) < 0.12f * scale) facing = std::max(facing, open[i]);
      if (std::abs(mesh.positions[i].x) > 1.6f * scale) away = std::min(away, open[i]);
    }
    EXPECT_LT(facing, 0.75f) << scale;
    EXPECT_GT(away, 0.95f) << scale;
  }
}

TEST(Openness, EmptyMeshGivesNoValues) { EXPECT_TRUE(app::bakeOpenness(ControlMesh{}).empty()); }

TEST(SpreadOverRefinement, LinearFunctionIsPreserved) {
  const auto limb = makeLimb();
  const auto height = [](const glm::vec3& p) { return 0.3f * p.x - 0.7f * p.y + 0.2f * p.z + 0.1f; };
  std::vector<float> values;
  for (const glm::vec3& p : limb->mesh.positions) values.push_back(height(p));
  for (const int depth : {1, 2, 5}) {
    Rig rig;
    rig.smoothing.depth = depth;
    rig.smoothing.patch = PatchKind::kFlat;
    Smoother smoother(limb);
    ASSERT_TRUE(smoother.prepare(rig).ok());
    Surface surface;
    smoother.smooth(bindPose(limb->skeleton), surface);
    const std::vector<float> spread = app::spreadOverRefinement(values, limb->mesh, *surface.refinement);
    ASSERT_EQ(spread.size(), surface.positions.size());
    for (std::size_t i = 0; i < spread.size(); ++i) EXPECT_NEAR(spread[i], height(surface.positions[i]), 1e-4f);
  }
}

}  // namespace
}  // namespace sinew::test
