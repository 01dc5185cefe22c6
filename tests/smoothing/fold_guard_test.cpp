// tests/smoothing/fold_guard_test.cpp: lifted skin is taken back where it turns over, continuously, and nowhere else.

#include "core/smoothing/finish/fold_guard.h"

#include <algorithm>
#include <cstdio>

#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/surface/lifted_sheet.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

/// Through the guard.
struct Scene : LiftedSheet {
  using LiftedSheet::LiftedSheet;

  [[nodiscard]] std::vector<glm::vec3> guarded(std::vector<glm::vec3> positions, std::vector<float>* kept = nullptr) {
    moved.find(mesh, refinement, patch, positions);
    const std::span<const float> shares = guard_.apply(mesh, refinement, moved.control, view(), positions);
    if (kept != nullptr) kept->assign(shares.begin(), shares.end());
    return positions;
  }

 private:
  FoldGuard guard_;
};

TEST(FoldGuard, LeavesNoTriangleTurned) {
  Scene scene(flatSheet());
  for (const float lift : {0.3f, 0.4f, 1.0f}) {
    const std::vector<glm::vec3> lifted = converging(scene.patch, lift);
    const std::vector<glm::vec3> guarded = scene.guarded(lifted);
    std::printf("  lift %.1f: least area %.3f, guarded %.3f\n", double{lift}, double{scene.leastArea(lifted)},
                double{scene.leastArea(guarded)});
    EXPECT_LT(scene.leastArea(lifted), 0.0f) << lift << ": nothing was turned";
    EXPECT_GE(scene.leastArea(guarded), 0.0f) << lift;
  }
}

TEST(FoldGuard, NeverLiftsFurtherAndLeavesTheRestAloneBitForBit) {
  Scene scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.4f);
  std::vector<float> kept;
  const std::vector<glm::vec3> guarded = scene.guarded(lifted, &kept);
  ASSERT_EQ(kept.size(), lifted.size());
  int unmoved = 0;
  int alone = 0;
  int back = 0;
  for (std::size_t v = 0; v < lifted.size(); ++v) {
    const bool wasMoved = !sameBits(lifted[v], scene.patch[v]);
    unmoved += wasMoved ? 0 : 1;
    alone += wasMoved && kept[v] == 1.0f ? 1 : 0;
    back += wasMoved && kept[v] < 1.0f ? 1 : 0;
    if (!wasMoved || kept[v] == 1.0f) {
      EXPECT_TRUE(sameBits(guarded[v], lifted[v])) << v;
    }
    EXPECT_GE(kept[v], 0.0f);
    EXPECT_LE(kept[v], 1.0f);
    const glm::vec3 expected = scene.patch[v] + kept[v] * (lifted[v] - scene.patch[v]);
    EXPECT_LT(glm::distance(guarded[v], expected), 1e-5f) << v;
  }
  EXPECT_GT(unmoved, 50);
  EXPECT_GT(alone, 10);
  EXPECT_GT(back, 10);
}

TEST(FoldGuard, TouchesNothingWhileEveryTriangleKeepsAQuarter) {
  Scene scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.05f);
  ASSERT_GE(scene.leastArea(lifted), 0.25f);
  ASSERT_GT(largestStep(lifted, scene.patch), 0.04f);
  std::vector<float> kept;
  EXPECT_TRUE(sameBytes(scene.guarded(lifted, &kept), lifted));
  EXPECT_TRUE(kept.empty());
}

TEST(FoldGuard, DoesNotDependOnTheOrderOfTriangles) {
  Scene scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.4f);
  const std::vector<glm::vec3> guarded = scene.guarded(lifted);
  ASSERT_GT(largestStep(guarded, lifted), 0.01f);
  std::ranges::reverse(scene.mesh.triangles);
  std::ranges::reverse(scene.refinement.triangles);
  EXPECT_TRUE(sameBytes(scene.guarded(lifted), guarded));
  for (auto& t : scene.refinement.triangles) std::ranges::rotate(t, t.begin() + 1);
  EXPECT_LT(largestStep(scene.guarded(lifted), guarded), 1e-5f);
}

TEST(FoldGuard, IsContinuousInTheLift) {
  Scene scene(flatSheet());
  const auto finish = [&](std::vector<glm::vec3> lifted) { return scene.guarded(std::move(lifted)); };
  const float slope = steepestStep(scene.patch, 0.6f, 200, finish);
  const float finer = steepestStep(scene.patch, 0.6f, 800, finish);
  EXPECT_LT(slope, 10.0f);
  EXPECT_LT(finer, 1.5f * slope) << "a jump stays as steps shrink";
}

// A pose folds the patch itself: one of its triangles shrinks to nothing and comes out on the other side. The lift
// stays as it is, so the skin may not jump.
TEST(FoldGuard, IsContinuousWhereAPatchTriangleTurnsOver) {
  constexpr int kSteps = 2000;
  const Sheet sheet{{{-1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}}, {{0, 1, 2}}};
  Scene scene(sheet);
  const glm::vec3 lift(0.0f, 0.0f, 0.1f);
  std::vector<glm::vec3> before;
  float worst = 0.0f;
  for (int i = 0; i <= kSteps; ++i) {
    // The third corner goes from one side of the edge between the others to the other side.
    scene.patch = scene.mesh.positions;
    scene.patch[2].y = 0.5f - static_cast<float>(i) / kSteps;
    std::vector<glm::vec3> lifted = scene.patch;
    lifted[0] += lift;
    lifted[1] += lift;
    lifted[2] += lift + glm::vec3(0.0f, 0.05f, 0.0f);  // Leans to one side all the time.
    const std::vector<glm::vec3> now = scene.guarded(lifted);
    if (i > 0) worst = std::max(worst, largestStep(before, now));
    before = now;
  }
  std::printf("  largest step %.4f, the patch's %.4f\n", double{worst}, 1.0 / kSteps);
  EXPECT_LT(worst, 20.0f / kSteps);
}

}  // namespace
}  // namespace sinew::test
