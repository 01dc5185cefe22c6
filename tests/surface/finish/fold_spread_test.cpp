// tests/surface/finish/fold_spread_test.cpp: corners of inverted triangles move apart along the patch, continuously,
// and nothing else moves.

#include "core/surface/finish/fold_spread.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/spread_sheet.h"

namespace sinew::test {
namespace {

constexpr float kCell = 0.1f;  ///< Side of a cell of flatSheet().

TEST(FoldSpread, UnfoldsInvertedTriangles) {
  SpreadSheet scene(flatSheet());
  for (const float lift : {0.25f, 0.3f, 0.4f}) {
    const std::vector<glm::vec3> lifted = converging(scene.patch, lift);
    const std::vector<glm::vec3> spread = scene.spread(lifted);
    std::printf("  lift %.2f: %d turned, afterwards %d\n", double{lift}, scene.turned(lifted), scene.turned(spread));
    ASSERT_GT(scene.turned(lifted), 10) << lift;
    EXPECT_LE(10 * scene.turned(spread), scene.turned(lifted)) << lift;
  }
}

// Along the patch, which is flat here: no pit opens where triangles were inverted.
TEST(FoldSpread, KeepsHeights) {
  SpreadSheet scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  const std::vector<glm::vec3> spread = scene.spread(lifted);
  ASSERT_GT(largestStep(lifted, spread), 0.01f) << "nothing was spread";
  for (std::size_t v = 0; v < lifted.size(); ++v) EXPECT_NEAR(spread[v].z, lifted[v].z, 1e-5f) << v;
}

TEST(FoldSpread, LeavesTheRestUnchangedBitForBit) {
  SpreadSheet scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  const std::vector<glm::vec3> spread = scene.spread(lifted);
  std::set<int> touched;
  for (const FoldMove& one : scene.touched) {
    EXPECT_TRUE(touched.insert(one.vertex).second) << one.vertex << " twice";
    EXPECT_TRUE(sameBits(one.from, lifted[static_cast<std::size_t>(one.vertex)]));
    EXPECT_FALSE(sameBits(one.from, scene.patch[static_cast<std::size_t>(one.vertex)])) << "an unmoved vertex";
  }
  int alone = 0;
  for (int v = 0; v < static_cast<int>(lifted.size()); ++v) {
    if (touched.contains(v)) continue;
    ++alone;
    EXPECT_TRUE(sameBits(spread[static_cast<std::size_t>(v)], lifted[static_cast<std::size_t>(v)])) << v;
  }
  EXPECT_GT(touched.size(), 10u);
  EXPECT_GT(alone, 200);
}

TEST(FoldSpread, ChangesNothingWithoutAFold) {
  SpreadSheet scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.05f);
  ASSERT_GE(scene.leastArea(lifted), FoldSpread::kLeastArea);
  ASSERT_GT(largestStep(lifted, scene.patch), 0.04f);
  EXPECT_TRUE(sameBytes(scene.spread(lifted), lifted));
  EXPECT_TRUE(scene.touched.empty());
}

TEST(FoldSpread, DoesNotDependOnTheOrderOfTriangles) {
  SpreadSheet scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.25f);
  const std::vector<glm::vec3> spread = scene.spread(lifted);
  ASSERT_GT(largestStep(spread, lifted), 0.01f);
  std::ranges::reverse(scene.mesh.triangles);
  std::ranges::reverse(scene.refinement.triangles);
  std::ranges::reverse(scene.bindFronts);
  EXPECT_LT(largestStep(scene.spread(lifted), spread), 1e-4f);
}

TEST(FoldSpread, IsContinuousInTheLift) {
  SpreadSheet scene(flatSheet());
  const auto finish = [&](std::vector<glm::vec3> lifted) { return scene.spread(std::move(lifted)); };
  const float slope = steepestStep(scene.patch, 0.4f, 200, finish);
  const float finer = steepestStep(scene.patch, 0.4f, 1600, finish);
  EXPECT_LT(finer, 2.0f * slope) << "a jump stays as steps shrink";
}

// A vertex that has only begun to move is not displaced by the fold next to it.
TEST(FoldSpread, IsContinuousAsAVertexStartsToMove) {
  SpreadSheet scene(flatSheet());
  std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  std::size_t nearest = 0;
  for (std::size_t v = 0; v < lifted.size(); ++v) {
    if (glm::length(scene.patch[v]) < glm::length(scene.patch[nearest])) nearest = v;
  }
  lifted[nearest] = scene.patch[nearest];
  const std::vector<glm::vec3> unmoved = scene.spread(lifted);
  lifted[nearest].z += 1e-5f;
  EXPECT_LT(largestStep(scene.spread(lifted), unmoved), 2e-3f);
}

/// Moves a patch vertex by `way` across the edges opposite to it, in that many steps, with a constant lift that leans
/// over its neighbors. @return the skin's largest step, relative to the patch's step
float steepestWhereThePatchTurns(float way, int steps) {
  SpreadSheet scene(flatSheet());
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
    const std::vector<glm::vec3> now = scene.spread(lifted);
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

// A pose folds the patch itself: its triangles shrink to nothing and reappear inverted.
TEST(FoldSpread, IsContinuousAsPatchTrianglesInvert) {
  const float slope = steepestWhereThePatchTurns(0.2f, 1000);
  EXPECT_LT(steepestWhereThePatchTurns(0.2f, 8000), 2.0f * slope) << "a jump stays as steps shrink";
}

// A border that moved would open a crack to the skin drawn next to it.
TEST(FoldSpread, KeepsBorders) {
  Sheet half = flatSheet();
  std::erase_if(half.triangles, [&](const auto& t) {
    return std::ranges::any_of(t, [&](int v) { return half.positions[static_cast<std::size_t>(v)].y < -0.05f; });
  });
  SpreadSheet scene(half);
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  const std::vector<glm::vec3> spread = scene.spread(lifted);
  ASSERT_GT(largestStep(lifted, spread), 0.01f);
  int border = 0;
  for (std::size_t v = 0; v < lifted.size(); ++v) {
    if (scene.patch[v].y > 0.05f || lifted[v] == scene.patch[v]) continue;
    ++border;
    EXPECT_TRUE(sameBits(spread[v], lifted[v])) << v;
  }
  EXPECT_GT(border, 5);
}

/// Squeezes one column of cells to the fraction `share` of its width in the patch.
void squeeze(std::vector<glm::vec3>& patch, float share) {
  for (glm::vec3& p : patch) {
    if (std::abs(p.x - kCell) < 0.1f * kCell) p.x = share * kCell;
  }
}

/// Lifts the sheet, and the squeezed column's far side towards its near one, until its triangles have that q.
std::vector<glm::vec3> narrowedTo(float q, const std::vector<glm::vec3>& patch, float share) {
  std::vector<glm::vec3> lifted = patch;
  for (glm::vec3& p : lifted) {
    if (p.x == share * kCell) p.x *= q;
    p.z += 0.3f;
  }
  return lifted;
}

// Slivers occur in the creases of a pose. Their q changes faster than the skin moves, in proportion to how much
// narrower they are than neighboring cells.
TEST(FoldSpread, MovesNoFasterAroundSlivers) {
  for (const float share : {0.5f, 0.2f, 0.1f}) {
    SpreadSheet scene(flatSheet());
    squeeze(scene.patch, share);
    constexpr int kSteps = 400;
    constexpr float kLeast = FoldSpread::kLeastArea;
    const float width = share * kCell;
    std::vector<glm::vec3> before;
    float furthest = 0.0f;
    float fastest = 0.0f;
    for (int i = 1; i <= kSteps; ++i) {
      const float q = kLeast * (1.0f - static_cast<float>(i) / kSteps);
      const std::vector<glm::vec3> lifted = narrowedTo(q, scene.patch, share);
      const std::vector<glm::vec3> spread = scene.spread(lifted);
      furthest = std::max(furthest, largestStep(spread, lifted) / ((kLeast - q) * width));
      if (i > 1) fastest = std::max(fastest, largestStep(spread, before) * kSteps / (kLeast * width));
      before = spread;
    }
    std::printf("  cells squeezed to %.1f: moved by %.1f of what is missing, %.1f times as fast as the skin\n",
                double{share}, double{furthest}, double{fastest});
    EXPECT_GT(furthest, 0.1f) << share;
    EXPECT_LT(furthest, 1.0f) << share;
    EXPECT_LT(fastest, 1.5f) << share;
  }
}

}  // namespace
}  // namespace sinew::test
