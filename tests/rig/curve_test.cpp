// tests/rig/curve_test.cpp: curves of keys and drivers pass through their points without overshoot.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/rigs/random_animation.h"

namespace sinew {
namespace {

TEST(Curves, PassThroughTheirPointsAndAreConstantOutside) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Curve curve = test::anyCurve(random, -3.0f, 8.0f, 16);
    for (const glm::vec2& point : curve.points) EXPECT_EQ(valueAt(curve, point.x), point.y);
    EXPECT_EQ(valueAt(curve, curve.points.front().x - 100.0f), curve.points.front().y);
    EXPECT_EQ(valueAt(curve, curve.points.back().x + 100.0f), curve.points.back().y);
  }
}

TEST(Curves, NeverOvershoot) {
  test::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Curve curve = test::anyCurve(random, 0.0f, 5.0f, 8);
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
      const glm::vec2& a = curve.points[k];
      const glm::vec2& b = curve.points[k + 1];
      float last = a.y;
      const float way = b.y >= a.y ? 1.0f : -1.0f;
      for (int step = 0; step <= 50; ++step) {
        const float x = std::min(b.x, a.x + (b.x - a.x) * static_cast<float>(step) / 50.0f);
        const float y = valueAt(curve, x);
        EXPECT_GE(y, std::min(a.y, b.y));
        EXPECT_LE(y, std::max(a.y, b.y));
        EXPECT_GE(way * (y - last), -1e-5f) << "not monotone between two points";
        last = y;
      }
    }
  }
}

TEST(Curves, SmoothCurvesHaveContinuousDerivatives) {
  test::Random random(3);
  int checked = 0;
  for (int i = 0; i < 500; ++i) {
    Curve curve = test::anyCurve(random, 0.0f, 12.0f, 6);
    curve.kind = CurveKind::kSmooth;
    for (std::size_t k = 1; k + 1 < curve.points.size(); ++k) {
      const glm::vec2& point = curve.points[k];
      const float room = std::min(point.x - curve.points[k - 1].x, curve.points[k + 1].x - point.x);
      if (room < 0.5f) continue;
      const float h = 0.005f * room;
      const float before = (point.y - valueAt(curve, point.x - h)) / h;
      const float after = (valueAt(curve, point.x + h) - point.y) / h;
      EXPECT_NEAR(before, after, 0.1f);
      ++checked;
    }
  }
  EXPECT_GT(checked, 200);
}

TEST(Curves, LargeNumbersStayFinite) {
  for (const CurveKind kind : {CurveKind::kSmooth, CurveKind::kLinear, CurveKind::kStep}) {
    EXPECT_TRUE(std::isfinite(valueAt({{{-3e38f, 0.0f}, {3e38f, 1.0f}}, kind}, 2e38f)));
    EXPECT_TRUE(std::isfinite(valueAt({{{1.0f, -3e38f}, {2.0f, 3e38f}, {3.0f, -3e38f}}, kind}, 1.5f)));
  }
}

TEST(Curves, EachKindInterpolatesAsDefined) {
  const std::vector<glm::vec2> points{{1.0f, 0.0f}, {3.0f, 8.0f}};
  EXPECT_FLOAT_EQ(valueAt({points, CurveKind::kLinear}, 1.5f), 2.0f);
  EXPECT_FLOAT_EQ(valueAt({points, CurveKind::kStep}, 2.9f), 0.0f);
  EXPECT_FLOAT_EQ(valueAt({points, CurveKind::kSmooth}, 1.5f), 8.0f * (3.0f / 16.0f - 2.0f / 64.0f));
}

}  // namespace
}  // namespace sinew
