// tests/smoothing/finish/fold_stages_test.cpp: what every stage that takes folds out keeps to.

#include <algorithm>
#include <cstdio>
#include <set>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/surface/fold_stage.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

template <class Stage>
class FoldStages : public testing::Test {
 protected:
  FoldStage<Stage> scene_{flatSheet()};
};

using Stages = testing::Types<FoldRelaxation, FoldSpread>;
TYPED_TEST_SUITE(FoldStages, Stages, );

TYPED_TEST(FoldStages, TurnsTrianglesBack) {
  auto& scene = this->scene_;
  for (const float lift : {0.25f, 0.3f, 0.4f}) {
    const std::vector<glm::vec3> lifted = converging(scene.patch, lift);
    const std::vector<glm::vec3> applied = scene.applied(lifted);
    std::printf("  lift %.2f: %d turned, after the stage %d\n", double{lift}, scene.turned(lifted),
                scene.turned(applied));
    ASSERT_GT(scene.turned(lifted), 10) << lift;
    // The relaxation is soft: what it leaves of large folds is for the spread.
    const bool whole = std::is_same_v<TypeParam, FoldSpread> || lift < 0.3f;
    EXPECT_LE(whole ? 10 * scene.turned(applied) : scene.turned(applied), scene.turned(lifted) - (whole ? 0 : 1))
        << lift;
  }
}

TYPED_TEST(FoldStages, LeavesTheRestAloneBitForBit) {
  auto& scene = this->scene_;
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  const std::vector<glm::vec3> applied = scene.applied(lifted);
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
    EXPECT_TRUE(sameBits(applied[static_cast<std::size_t>(v)], lifted[static_cast<std::size_t>(v)])) << v;
  }
  EXPECT_GT(touched.size(), 10u);
  EXPECT_GT(alone, 200);
}

TYPED_TEST(FoldStages, TouchesNothingWithoutAFold) {
  auto& scene = this->scene_;
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.05f);
  ASSERT_GE(scene.leastArea(lifted), 0.4f);
  ASSERT_GT(largestStep(lifted, scene.patch), 0.04f);
  EXPECT_TRUE(sameBytes(scene.applied(lifted), lifted));
  EXPECT_TRUE(scene.touched.empty());
}

TYPED_TEST(FoldStages, DoesNotDependOnTheOrderOfTriangles) {
  auto& scene = this->scene_;
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.25f);
  const std::vector<glm::vec3> applied = scene.applied(lifted);
  ASSERT_GT(largestStep(applied, lifted), 0.01f);
  std::ranges::reverse(scene.mesh.triangles);
  std::ranges::reverse(scene.refinement.triangles);
  std::ranges::reverse(scene.bindFronts);
  EXPECT_LT(largestStep(scene.applied(lifted), applied), 1e-4f);
}

TYPED_TEST(FoldStages, IsContinuousInTheLift) {
  auto& scene = this->scene_;
  const auto finish = [&](std::vector<glm::vec3> lifted) { return scene.applied(std::move(lifted)); };
  const float slope = steepestStep(scene.patch, 0.4f, 200, finish);
  const float finer = steepestStep(scene.patch, 0.4f, 1600, finish);
  EXPECT_LT(finer, 2.0f * slope) << "a jump stays as steps shrink";
}

}  // namespace
}  // namespace sinew::test
