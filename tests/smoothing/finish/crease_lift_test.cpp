// tests/smoothing/finish/crease_lift_test.cpp: heights fall where a pose folds the patch, and nowhere else.

#include "core/smoothing/finish/crease_lift.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/surface/lifted_sheet.h"

namespace sinew::test {
namespace {

/// A flat sheet all of whose skin is lifted by 1.
class CreaseLiftTest : public testing::Test {
 protected:
  CreaseLiftTest() {
    sheet_.moved.refined.resize(sheet_.refinement.triangles.size());
    for (int i = 0; i < static_cast<int>(sheet_.moved.refined.size()); ++i) at(sheet_.moved.refined, i) = i;
  }

  /// The sheet with its middle rows turned over by the share: they run back from where they came, normals as in the
  /// bind pose. 0 is flat, 1 folded back whole.
  std::vector<float> lowered(float share) {
    sheet_.patch = sheet_.mesh.positions;
    for (glm::vec3& p : sheet_.patch) {
      const float inside = std::clamp(p.x, -0.1f, 0.1f);
      p.x -= 2.0f * share * inside;
    }
    std::vector<float> heights(sheet_.patch.size(), 1.0f);
    crease_.lower(sheet_.refinement, sheet_.moved, sheet_.view(), heights);
    return heights;
  }

  LiftedSheet sheet_{flatSheet()};
  CreaseLift crease_;
};

TEST_F(CreaseLiftTest, TakesThreeFifthsWhereTheSkinIsTurnedOver) {
  const std::vector<float> heights = lowered(1.0f);
  int creased = 0;
  for (std::size_t v = 0; v < heights.size(); ++v) {
    const float x = std::abs(sheet_.mesh.positions[v].x);
    if (x < 0.11f) {
      EXPECT_NEAR(heights[v], 0.4f, 1e-6f) << v;
      ++creased;
    } else {
      EXPECT_EQ(heights[v], 1.0f) << v;
    }
  }
  EXPECT_GT(creased, 40);
}

TEST_F(CreaseLiftTest, LeavesASheetThatIsHardlySqueezed) {
  const std::vector<float> ones(sheet_.patch.size(), 1.0f);
  EXPECT_EQ(lowered(0.0f), ones);
  EXPECT_EQ(lowered(0.1f), ones);
  EXPECT_NE(lowered(0.5f), ones);
  EXPECT_EQ(lowered(0.0f), ones) << "nothing is left from the call before";
}

TEST_F(CreaseLiftTest, IsContinuousWhereTheSkinFoldsOver) {
  constexpr int kSteps = 1000;
  std::vector<float> before = lowered(0.0f);
  float worst = 0.0f;
  for (int i = 1; i <= kSteps; ++i) {
    const std::vector<float> now = lowered(static_cast<float>(i) / kSteps);
    for (std::size_t v = 0; v < now.size(); ++v) worst = std::max(worst, std::abs(now[v] - before[v]));
    before = now;
  }
  EXPECT_LT(worst, 10.0f / kSteps);
}

TEST_F(CreaseLiftTest, SliversOfTheBindPoseHaveNoSay) {
  std::ranges::fill(sheet_.bindFronts, 0.04f);
  EXPECT_EQ(lowered(1.0f), std::vector<float>(sheet_.patch.size(), 1.0f));
}

}  // namespace
}  // namespace sinew::test
