// tests/document/auto_depth_test.cpp: automatic depth is monotone, bounded and stable.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "app/document/playback.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew::app {
namespace {

TEST(AutoDepth, GrowsWithScreenSizeFromOneToTheMaximum) {
  int last = 1;
  for (float pixels = 1.0f; pixels < 20000.0f; pixels *= 1.05f) {
    const int depth = autoDepth(0.05f, pixels, 0);
    EXPECT_GE(depth, last);
    EXPECT_LE(depth, kMaxAutoDepth);
    last = depth;
  }
  EXPECT_EQ(autoDepth(0.05f, 1.0f, 0), 1);
  EXPECT_EQ(last, kMaxAutoDepth);
}

TEST(AutoDepth, EdgesAreNearTheTargetLength) {
  for (float pixels = 400.0f; pixels < 1200.0f; pixels += 7.0f) {
    const float edge = 0.05f * pixels / static_cast<float>(autoDepth(0.05f, pixels, 0));
    EXPECT_NEAR(edge, kAutoEdgePixels, 0.25f * kAutoEdgePixels) << pixels;
  }
}

TEST(AutoDepth, DoesNotFlickerAtAThreshold) {
  // A camera that oscillates by a few percent around every size: at most one change in a hundred oscillations.
  for (float pixels = 100.0f; pixels < 1500.0f; pixels *= 1.01f) {
    int depth = autoDepth(0.05f, pixels, 0);
    int changes = 0;
    for (int breath = 0; breath < 200; ++breath) {
      const int next = autoDepth(0.05f, pixels * (1.0f + 0.02f * std::sin(0.7f * static_cast<float>(breath))), depth);
      changes += next != depth;
      depth = next;
    }
    EXPECT_LE(changes, 1) << pixels;
  }
}

TEST(AutoDepth, FollowsALargeSizeChange) {
  int depth = autoDepth(0.05f, 1500.0f, 0);
  depth = autoDepth(0.05f, 150.0f, depth);
  EXPECT_EQ(depth, 1);
  EXPECT_EQ(autoDepth(0.05f, std::numeric_limits<float>::quiet_NaN(), 3), 3);
}

TEST(AutoDepth, MeanEdgeDoesNotDependOnUnits) {
  Character character = *test::makeLimb();
  const float fraction = meanEdgeFraction(character.mesh, character.height);
  for (glm::vec3& p : character.mesh.positions) p *= 100.0f;
  EXPECT_NEAR(meanEdgeFraction(character.mesh, 100.0f * character.height), fraction, 1e-5f);
}

TEST(AutoTolerance, DoesNotFlickerOnABorder) {
  for (float pixels = 100.0f; pixels < 1500.0f; pixels *= 1.01f) {
    float tolerance = autoTolerance(pixels, 0.0f);
    int changes = 0;
    for (int breath = 0; breath < 200; ++breath) {
      const float next =
          autoTolerance(pixels * (1.0f + 0.02f * std::sin(0.7f * static_cast<float>(breath))), tolerance);
      changes += next != tolerance;
      tolerance = next;
    }
    EXPECT_LE(changes, 1) << pixels;
  }
}

}  // namespace
}  // namespace sinew::app
