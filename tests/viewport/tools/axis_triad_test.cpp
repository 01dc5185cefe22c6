// tests/viewport/tools/axis_triad_test.cpp: the axis gizmo shows the camera and rotates it.
#include "app/viewport/tools/axis_triad.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/rigs/random_rigs.h"

namespace sinew::app {
namespace {

using test::Random;

constexpr glm::ivec2 kWindow{900, 600};
constexpr std::array<AxisEnd, 6> kEnds{AxisEnd::kX,      AxisEnd::kMinusX, AxisEnd::kY,
                                       AxisEnd::kMinusY, AxisEnd::kZ,      AxisEnd::kMinusZ};

glm::vec3 direction(AxisEnd end) {
  switch (end) {
    case AxisEnd::kX:
      return {1, 0, 0};
    case AxisEnd::kMinusX:
      return {-1, 0, 0};
    case AxisEnd::kY:
      return {0, 1, 0};
    case AxisEnd::kMinusY:
      return {0, -1, 0};
    case AxisEnd::kZ:
      return {0, 0, 1};
    case AxisEnd::kMinusZ:
      break;
  }
  return {0, 0, -1};
}

Camera anyCamera(Random& random) {
  Camera camera;
  camera.orthographic = random.chance(0.5f);
  camera.stand = {glm::vec3(random.uniform(-1, 1)), random.uniform(1, 6), random.uniform(-3, 3),
                  random.uniform(-1.3f, 1.3f)};
  return camera;
}

TriadLayout::End endOf(const TriadLayout& layout, AxisEnd end) {
  return *std::ranges::find(layout.ends, end, &TriadLayout::End::end);
}

/// One frame with the pointer at a pixel.
ViewportInput at(const glm::vec2& pixel) {
  ViewportInput input;
  input.mouse = pixel;
  return input;
}
ViewportInput press(const glm::vec2& pixel) {
  ViewportInput input = at(pixel);
  input.buttons[0] = {true, true, false, false};
  return input;
}
ViewportInput hold(const glm::vec2& pixel) {
  ViewportInput input = at(pixel);
  input.buttons[0].down = true;
  return input;
}
ViewportInput release(const glm::vec2& pixel) {
  ViewportInput input = at(pixel);
  input.buttons[0].released = true;
  return input;
}

void click(AxisTriad& triad, Camera& camera, const glm::vec2& pixel) {
  EXPECT_TRUE(routeTriad(triad, camera, press(pixel), kWindow, 1.0f));
  EXPECT_TRUE(routeTriad(triad, camera, release(pixel), kWindow, 1.0f));
}

glm::vec3 forwardAfter(Camera camera) {
  advance(camera, 1.0f);
  return viewOf(camera, kWindow).forwardInWorld();
}

TEST(AxisTriad, EndsMatchTheAxesInThePicture) {
  Random random(31);
  for (int i = 0; i < 100; ++i) {
    const Camera camera = anyCamera(random);
    const float scale = random.uniform(1.0f, 2.5f);
    const TriadLayout layout = layoutTriad(camera, kWindow, scale);
    const glm::mat3 rotation(viewOf(camera, kWindow).viewFromWorld);
    float depth = -2.0f;
    for (const TriadLayout::End& end : layout.ends) {
      const glm::vec3 seen = rotation * direction(end.end);
      const glm::vec2 away = (end.pixel - layout.center) / layout.radius;
      EXPECT_LT(glm::distance(away, 0.78f * glm::vec2(seen.x, -seen.y)), 1e-3f);
      EXPECT_GE(end.depth, depth);  // Farthest first.
      depth = end.depth;
      EXPECT_LE(glm::length(away) + end.radius / layout.radius, 1.03f);
    }
    // All of it lies in the picture, in the lower right corner.
    EXPECT_LE(layout.center.x + layout.radius, static_cast<float>(kWindow.x));
    EXPECT_LE(layout.center.y + layout.radius, static_cast<float>(kWindow.y));
    EXPECT_FLOAT_EQ(layout.radius, kTriadRadius * scale);
  }
}

TEST(AxisTriad, ClickLooksAlongTheAxisAndTheNextFromTheOpposite) {
  Random random(32);
  for (int i = 0; i < 60; ++i) {
    const AxisEnd end = kEnds[static_cast<std::size_t>(i) % 6];
    Camera camera = anyCamera(random);
    AxisTriad triad;
    const glm::vec2 pixel = endOf(layoutTriad(camera, kWindow, 1.0f), end).pixel;
    if (axisEndAt(layoutTriad(camera, kWindow, 1.0f), pixel) != end) continue;  // Behind another.
    click(triad, camera, pixel);
    EXPECT_TRUE(isMoving(camera));
    EXPECT_LT(glm::distance(forwardAfter(camera), -direction(end)), 1e-4f);
    advance(camera, 1.0f);
    const TriadLayout arrived = layoutTriad(camera, kWindow, 1.0f);
    EXPECT_EQ(axisEndAt(arrived, arrived.center), end);  // It has moved to the middle, nearest to the eye.
    click(triad, camera, arrived.center);
    EXPECT_LT(glm::distance(forwardAfter(camera), direction(end)), 1e-4f);
  }
}

TEST(AxisTriad, DragOrbitsWithoutClicking) {
  Camera camera;
  AxisTriad triad;
  const TriadLayout layout = layoutTriad(camera, kWindow, 1.0f);
  const glm::vec2 start = endOf(layout, AxisEnd::kZ).pixel;
  const CameraStand before = camera.stand;
  EXPECT_TRUE(routeTriad(triad, camera, press(start), kWindow, 1.0f));
  for (int step = 1; step <= 20; ++step) {
    // Far outside the ball: the drag continues.
    EXPECT_TRUE(
        routeTriad(triad, camera, hold(start + glm::vec2(-10.0f * static_cast<float>(step), 0)), kWindow, 1.0f));
  }
  EXPECT_TRUE(routeTriad(triad, camera, release(start + glm::vec2(-200, 0)), kWindow, 1.0f));
  EXPECT_FALSE(triad.pressed);
  EXPECT_FALSE(isMoving(camera));
  EXPECT_EQ(camera.stand.target, before.target);
  EXPECT_EQ(camera.stand.distance, before.distance);
  EXPECT_NE(camera.stand.yaw, before.yaw);
}

TEST(AxisTriad, SmallMotionCountsAsAClick) {
  for (const float scale : {1.0f, 2.0f}) {
    for (const float moved : {0.9f * kDragThreshold, 1.1f * kDragThreshold}) {
      Camera camera;
      AxisTriad triad;
      const glm::vec2 start = endOf(layoutTriad(camera, kWindow, scale), AxisEnd::kZ).pixel;
      const glm::vec2 end = start + glm::vec2(0, moved * scale);
      routeTriad(triad, camera, press(start), kWindow, scale);
      routeTriad(triad, camera, hold(end), kWindow, scale);
      routeTriad(triad, camera, release(end), kWindow, scale);
      EXPECT_EQ(isMoving(camera), moved < kDragThreshold) << moved << " pixels at scale " << scale;
    }
  }
}

TEST(AxisTriad, TakesTheMouseOnlyOnTheBallAndNeverDuringOtherDrags) {
  Camera camera;
  AxisTriad triad;
  const TriadLayout layout = layoutTriad(camera, kWindow, 1.0f);
  EXPECT_TRUE(passTriad(triad, camera, at(layout.center), kWindow, 1.0f, false).mouseTaken);
  EXPECT_FALSE(passTriad(triad, camera, at({100, 100}), kWindow, 1.0f, false).mouseTaken);
  EXPECT_FALSE(passTriad(triad, camera, press({100, 100}), kWindow, 1.0f, false).mouseTaken);
  // A drag of something else passes over it.
  EXPECT_FALSE(passTriad(triad, camera, hold(layout.center), kWindow, 1.0f, true).mouseTaken);
  EXPECT_FALSE(triad.ballHovered);
  // A panel lies over it.
  ViewportInput covered = press(layout.center);
  covered.mouseTaken = true;
  const CameraStand before = camera.stand;
  EXPECT_FALSE(routeTriad(triad, camera, covered, kWindow, 1.0f));
  EXPECT_FALSE(triad.pressed);
  EXPECT_EQ(camera.stand.yaw, before.yaw);
  // A missed release (the window lost the focus) ends the press anyway.
  EXPECT_TRUE(routeTriad(triad, camera, press(layout.center + glm::vec2(0, 30)), kWindow, 1.0f));
  routeTriad(triad, camera, at({100, 100}), kWindow, 1.0f);
  EXPECT_FALSE(triad.pressed);
}

TEST(AxisTriad, DescribesTheClick) {
  Camera camera;
  AxisTriad triad;
  EXPECT_EQ(describe(triad), "");
  for (const AxisEnd end : kEnds) {
    camera.stand.yaw = 0.5f;
    camera.stand.pitch = 0.35f;
    const TriadLayout layout = layoutTriad(camera, kWindow, 1.0f);
    routeTriad(triad, camera, at(endOf(layout, end).pixel), kWindow, 1.0f);
    EXPECT_EQ(triad.hovered, axisEndAt(layout, endOf(layout, end).pixel));
    EXPECT_NE(describe(triad).find("Click"), std::string::npos);
  }
}

}  // namespace
}  // namespace sinew::app
