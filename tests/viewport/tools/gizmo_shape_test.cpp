// tests/viewport/tools/gizmo_shape_test.cpp: dragging the handles of belly and bend.

#include "app/viewport/tools/gizmo.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/viewport/tools/camera.h"

namespace sinew::app {
namespace {

constexpr GizmoHandle kBoth[] = {GizmoHandle::kBelly, GizmoHandle::kBend};

struct ShapeHandles : testing::Test {
  GizmoState state;
  GizmoContext context;
  Placement placement;

  ShapeHandles() {
    Camera camera;
    camera.scene = {glm::vec3(-1.0f), glm::vec3(1.0f)};
    camera.stand.target = glm::vec3(0.0f);
    camera.stand.distance = 4.0f;
    camera.stand.yaw = 0.0f;
    camera.stand.pitch = 0.0f;
    context.view = viewOf(camera, {1280, 800});
    context.shapeHandles = true;
    state.mode = GizmoMode::kPoles;
    placement.radii = {0.2f, 0.6f, 0.25f};
    placement.shape.bend = {0.2f, 0.1f};
    placement.shape.belly = 0.1f;
  }

  [[nodiscard]] GizmoLayout layout() const { return layoutGizmo(state, placement, context); }

  /// Presses a handle, moves the pointer and releases.
  Placement pulled(GizmoHandle handle, const glm::vec2& by) {
    const GizmoLayout seen = layout();
    const HandleShape* shape = seen.find(handle);
    EXPECT_NE(shape, nullptr);
    const glm::vec2 from = shape ? shape->anchor : glm::vec2(0.0f);
    beginDrag(state, handle, placement, from, context);
    ViewportInput input;
    input.mouse = from + by;
    input.buttons[static_cast<std::size_t>(MouseButton::kLeft)].released = true;
    return updateDrag(state, input, context).placement;
  }
};

TEST_F(ShapeHandles, AreShownOnlyForShapesInPoleMode) {
  for (const GizmoHandle handle : kBoth) EXPECT_NE(layout().find(handle), nullptr);
  state.mode = GizmoMode::kMove;
  for (const GizmoHandle handle : kBoth) EXPECT_EQ(layout().find(handle), nullptr);
  state.mode = GizmoMode::kPoles;
  context.shapeHandles = false;
  for (const GizmoHandle handle : kBoth) EXPECT_EQ(layout().find(handle), nullptr);
  context.shapeHandles = true;
  placement.shape = {};
  for (const GizmoHandle handle : kBoth) EXPECT_EQ(layout().find(handle), nullptr);
}

TEST_F(ShapeHandles, FollowThePointer) {
  for (const GizmoHandle handle : kBoth) {
    const bool belly = handle == GizmoHandle::kBelly;
    const glm::vec2 by = belly ? glm::vec2(0.0f, -14.0f) : glm::vec2(25.0f, 0.0f);
    const Placement now = pulled(handle, by);
    const glm::vec2 before = layout().find(handle)->outline[0];
    Placement kept = placement;
    placement = now;
    const glm::vec2 after = layout().find(handle)->outline[0];
    placement = kept;
    EXPECT_NE(now.shape, placement.shape);
    EXPECT_EQ(now.center, placement.center);
    EXPECT_EQ(now.radii, placement.radii);
    EXPECT_NEAR((after - before).x, by.x, belly ? 6.0f : 2.0f);
    EXPECT_NEAR((after - before).y, by.y, belly ? 2.0f : 6.0f);
  }
}

TEST_F(ShapeHandles, StopAtTheLimits) {
  context.reach = 1.4f;
  EXPECT_FLOAT_EQ(pulled(GizmoHandle::kBelly, {0.0f, -2000.0f}).shape.belly, mostBelly(0.0f, 1.4f));
  const Shape bent = pulled(GizmoHandle::kBend, {600.0f, 0.0f}).shape;
  EXPECT_LE(std::abs(bent.bend.x), kMostBend);
  EXPECT_LE(std::abs(bent.bend.y), kMostBend);
}

TEST_F(ShapeHandles, TypedNumbersSetTheValue) {
  EXPECT_FLOAT_EQ(withBelly(placement, 0.3f, 2.0f, 0.15f).shape.belly, 0.15f);
  EXPECT_EQ(withBend(placement, Way::kWhole, {}, 2.0f, 0.4f).shape.bend, glm::vec2(0.4f, 0.1f));
  EXPECT_EQ(withBend(placement, Way::kZ, {}, 2.0f, 0.4f).shape.bend, glm::vec2(0.2f, 0.4f));
  EXPECT_EQ(withBend(placement, Way::kX, glm::vec3(0.1f), 2.0f, {}).shape.bend, glm::vec2(0.3f, 0.1f));
}

TEST_F(ShapeHandles, BellyHandleLiesOnTheThickestSection) {
  for (const float core : {0.0f, 0.6f}) {
    placement.shape = legalShape({core, 0.25f, {0.3f, -0.2f}}, 1.4f);
    for (const glm::vec3& eye : {glm::vec3(1, 0, 0), glm::vec3(-1, 0.5f, 0.3f), glm::vec3(0, 0, -1)}) {
      const glm::vec3 point = thickestInBone(placement, eye) / placement.radii;
      EXPECT_FLOAT_EQ(point.y, thickestAt(placement.shape));
      EXPECT_NEAR(std::sqrt(unitShape(placement.shape, 1.4f).rSquared(point / 1.4f)) * 1.4f, 1.0f, 1e-4f);
    }
  }
}

}  // namespace
}  // namespace sinew::app
