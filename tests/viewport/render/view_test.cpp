// tests/viewport/render/view_test.cpp: pixel and ray conversions are inverse; views contain their target.

#include "app/viewport/render/view.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "app/viewport/render/ground_drawer.h"

namespace sinew::test {
namespace {

using app::Ray;
using app::View;

class ViewProjection : public ::testing::TestWithParam<bool> {
 protected:
  float between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }
  glm::vec3 point(float size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
  std::vector<glm::vec3> cloud(float size) {
    std::vector<glm::vec3> points;
    const glm::vec3 middle = point(5.0f * size);
    for (int i = 0; i < 40; ++i) points.push_back(middle + point(size) * glm::vec3(1.0f, 0.6f, 0.2f));
    return points;
  }
  glm::ivec2 pictureSize() {
    return {100 + static_cast<int>(between(0, 900)), 100 + static_cast<int>(between(0, 900))};
  }

  std::mt19937 random_{20};
};

TEST_P(ViewProjection, PixelsAndRaysAreInverse) {
  for (int trial = 0; trial < 500; ++trial) {
    const float size = std::pow(10.0f, between(-2, 3));
    const auto points = cloud(size);
    const View view = app::framedView(points, between(-4, 4), between(-1.5f, 1.5f), pictureSize(), GetParam());
    for (const glm::vec3& p : points) {
      const glm::vec3 pixel = view.toPixel(p);
      ASSERT_GE(pixel.z, -1.0f);
      ASSERT_LE(pixel.z, 1.0f);
      const Ray ray = view.rayThrough(glm::vec2(pixel));
      EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-5f);
      const float along = glm::dot(p - ray.origin, ray.direction);
      EXPECT_GT(along, 0.0f);
      const float off = glm::distance(p, ray.origin + along * ray.direction);
      EXPECT_LT(off, 0.05f * view.unitsPerPixelAt(p) + 1e-5f * size);
    }
  }
}

TEST_P(ViewProjection, UnitsPerPixelMatchesASmallStep) {
  for (int trial = 0; trial < 200; ++trial) {
    const auto points = cloud(3.0f);
    const View view = app::framedView(points, between(-4, 4), between(-1.5f, 1.5f), pictureSize(), GetParam());
    const glm::vec3 right(glm::transpose(glm::mat3(view.viewFromWorld))[0]);
    const float unit = view.unitsPerPixelAt(points[0]);
    const glm::vec3 step = view.toPixel(points[0] + 20.0f * unit * right) - view.toPixel(points[0]);
    EXPECT_NEAR(step.x, 20.0f, 0.1f);
    EXPECT_NEAR(step.y, 0.0f, 0.1f);
    EXPECT_NEAR(glm::length(view.forwardInWorld()), 1.0f, 1e-5f);
  }
}

TEST_P(ViewProjection, FramingIsTight) {
  for (int trial = 0; trial < 300; ++trial) {
    const auto points = cloud(std::pow(10.0f, between(-2, 3)));
    const glm::ivec2 size = pictureSize();
    const float margin = between(0.0f, 0.3f);
    const View view = app::framedView(points, between(-4, 4), between(-1.5f, 1.5f), size, GetParam(), margin);
    glm::vec2 low(1e9f), high(-1e9f);
    for (const glm::vec3& p : points) {
      const glm::vec2 share = glm::vec2(view.toPixel(p)) / glm::vec2(size);
      low = glm::min(low, share);
      high = glm::max(high, share);
    }
    EXPECT_GE(std::min(low.x, low.y), margin - 2e-3f);
    EXPECT_LE(std::max(high.x, high.y), 1.0f - margin + 2e-3f);
    // One axis fills its range up to the margins.
    const glm::vec2 free = glm::max(low - margin, 1.0f - margin - high);
    EXPECT_LT(std::min(free.x, free.y), 4e-3f);
  }
}

TEST_P(ViewProjection, FrontLeftAndTopLookAlongTheirAxes) {
  const Bounds box{glm::vec3(-1), glm::vec3(1)};
  const auto forward = [&](float yaw, float pitch) {
    return app::framedView(box, yaw, pitch, {100, 80}, GetParam()).forwardInWorld();
  };
  EXPECT_LT(glm::distance(forward(0, 0), glm::vec3(0, 0, -1)), 1e-5f);
  EXPECT_LT(glm::distance(forward(1.5707963f, 0), glm::vec3(-1, 0, 0)), 1e-5f);
  EXPECT_LT(glm::distance(forward(0, 1.5707963f), glm::vec3(0, -1, 0)), 1e-5f);
}

TEST_P(ViewProjection, FramesAPointOrNothing) {
  const std::vector<glm::vec3> one{{3, 4, 5}};
  const View point = app::framedView(one, 0.3f, 0.2f, {200, 100}, GetParam());
  EXPECT_NEAR(point.toPixel(one[0]).x, 100.0f, 0.5f);
  EXPECT_NEAR(point.toPixel(one[0]).y, 50.0f, 0.5f);
  const View nothing = app::framedView(Bounds{}, 0.3f, 0.2f, {200, 100}, GetParam());
  EXPECT_LT(std::abs(nothing.toPixel(glm::vec3(0)).z), 1.0f);
}

TEST_P(ViewProjection, OrthographicMatchesPerspectiveScaleAtTheTarget) {
  const glm::vec3 target(1, 2, 3);
  const View view = app::orbitView(target, 0.4f, 0.3f, 5.0f, {300, 200}, GetParam(), 1.8f);
  EXPECT_NEAR(view.unitsPerPixelAt(target), 2.0f * 5.0f * std::tan(0.5f * app::kFieldOfView) / 200.0f, 1e-4f);
  EXPECT_NEAR(view.toPixel(target).x, 150.0f, 1e-2f);
  EXPECT_NEAR(view.toPixel(target).y, 100.0f, 1e-2f);
}

INSTANTIATE_TEST_SUITE_P(PerspectiveAndOrthographic, ViewProjection, ::testing::Bool());

TEST(View, PointBehindTheEyeIsOutOfDepthRange) {
  const View view = app::orbitView(glm::vec3(0), 0, 0, 5.0f, {300, 200}, false, 2.0f);
  EXPECT_GT(view.toPixel({0, 0, 20}).z, 1.0f);
}

TEST(GridZoom, LevelsChangeContinuously) {
  const float height = 1.8f;
  float cell = 0.0f, towards = 0.0f;
  for (int i = 0; i <= 400; ++i) {
    const float distance = height * 0.5f * std::pow(1.02f, static_cast<float>(i));
    const View view = app::orbitView(glm::vec3(0), 0.4f, 0.3f, distance, {300, 200}, i % 2 == 0, 2.0f);
    const app::GridZoom zoom = app::gridZoom(view, glm::vec3(0), height);
    EXPECT_GE(zoom.towardsNext, 0.0f);
    EXPECT_LE(zoom.towardsNext, 1.0f);
    EXPECT_GE(zoom.reach, 1.0f);
    if (i > 0 && zoom.cell == cell) {
      EXPECT_NEAR(zoom.towardsNext, towards, 0.03f);
    }
    if (i > 0 && zoom.cell != cell) {
      EXPECT_NEAR(zoom.cell, 5.0f * cell, 1e-3f * cell);
      EXPECT_NEAR(zoom.towardsNext + 1.0f, towards, 0.03f);
    }
    cell = zoom.cell;
    towards = zoom.towardsNext;
  }
  EXPECT_GT(cell, 20.0f * app::gridCell(height));
}

TEST(ExtremePoints, FrameNearlyLikeAllPoints) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  std::vector<glm::vec3> points;
  for (int i = 0; i < 3000; ++i) points.push_back({normal(random), 2.0f * normal(random), normal(random)});
  const std::vector<glm::vec3> few = app::extremePoints(points);
  EXPECT_LT(few.size(), 200u);
  const View view = app::framedView(few, 0.7f, 0.3f, {400, 300}, false, 0.05f);
  for (const glm::vec3& p : points) {
    EXPECT_GT(view.toPixel(p).x, 0.0f);
    EXPECT_LT(view.toPixel(p).x, 400.0f);
    EXPECT_GT(view.toPixel(p).y, 0.0f);
    EXPECT_LT(view.toPixel(p).y, 300.0f);
  }
}

}  // namespace
}  // namespace sinew::test
