// tests/smoothing/finish/fold_spread_test.cpp: corners of turned triangles move apart along the patch, continuously.

#include "core/smoothing/finish/fold_spread.h"

#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/smoothing/finish/fold_relaxation.h"
#include "tests/support/surface/fold_stage.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

using SpreadStage = FoldStage<FoldSpread>;

// Along the patch, which is flat here: no pit opens where triangles were turned.
TEST(FoldSpread, KeepsHeights) {
  SpreadStage scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  const std::vector<glm::vec3> spread = scene.applied(lifted);
  ASSERT_GT(largestStep(lifted, spread), 0.01f) << "nothing was spread";
  for (std::size_t v = 0; v < lifted.size(); ++v) EXPECT_NEAR(spread[v].z, lifted[v].z, 1e-5f) << v;
}

/// A vertex of the patch goes by `way` across the edges opposite to it, in that many steps; the lift stays as it is,
/// and leans over its neighbors. @return how far the skin steps at most, over the patch's own step
float steepestWhereThePatchTurns(float way, int steps) {
  SpreadStage scene(flatSheet());
  const auto middle = static_cast<std::size_t>(
      std::ranges::min_element(scene.mesh.positions, {}, [](const glm::vec3& p) { return glm::length(p); }) -
      scene.mesh.positions.begin());
  std::vector<glm::vec3> before;
  float worst = 0.0f;
  float moved = 0.0f;
  for (int i = 0; i <= steps; ++i) {
    scene.patch = scene.mesh.positions;
    scene.patch[middle].y += way * static_cast<float>(i) / static_cast<float>(steps);
    std::vector<glm::vec3> lifted = scene.patch;
    for (glm::vec3& p : lifted) p.z += 0.2f * std::max(0.0f, 1.0f - glm::length(p));
    lifted[middle] = scene.patch[middle] + glm::vec3(0.0f, 0.15f, 0.2f);
    const std::vector<glm::vec3> now = scene.applied(lifted);
    moved = std::max(moved, largestStep(now, lifted));
    if (i > 0) worst = std::max(worst, largestStep(before, now));
    before = now;
  }
  const float slope = worst * static_cast<float>(steps) / way;
  std::printf("  %d steps: the largest is %.1f times the patch's; spread by up to %.3f\n", steps, double{slope},
              double{moved});
  EXPECT_GT(moved, 0.01f) << "nothing was spread";
  return slope;
}

// A pose folds the patch itself: its triangles shrink to nothing and come out on the other side.
TEST(FoldSpread, IsContinuousWherePatchTrianglesTurnOver) {
  const float slope = steepestWhereThePatchTurns(0.2f, 1000);
  EXPECT_LT(steepestWhereThePatchTurns(0.2f, 8000), 2.0f * slope) << "a jump stays as steps shrink";
}

// Beside a border nothing opens: it stays.
TEST(FoldSpread, KeepsBorders) {
  Sheet half = flatSheet();
  std::erase_if(half.triangles, [&](const auto& t) {
    return std::ranges::any_of(t, [&](int v) { return half.positions[static_cast<std::size_t>(v)].y < -0.05f; });
  });
  SpreadStage scene(half);
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  const std::vector<glm::vec3> spread = scene.applied(lifted);
  ASSERT_GT(largestStep(lifted, spread), 0.01f);
  int border = 0;
  for (std::size_t v = 0; v < lifted.size(); ++v) {
    if (scene.patch[v].y > 0.05f || lifted[v] == scene.patch[v]) continue;
    ++border;
    EXPECT_TRUE(sameBits(spread[v], lifted[v])) << v;
  }
  EXPECT_GT(border, 5);
}

}  // namespace
}  // namespace sinew::test
