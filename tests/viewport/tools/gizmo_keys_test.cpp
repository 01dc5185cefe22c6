// tests/viewport/tools/gizmo_keys_test.cpp: locks, snaps, precision, typed numbers, canceling, and bones that move
// during a drag.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/viewport/tools/random_gizmo.h"

namespace sinew::app {
namespace {

using test::GizmoScene;
using test::pointerAt;
using test::releasedAt;

constexpr float kHalfCircle = std::numbers::pi_v<float>;
constexpr glm::vec2 kPress{640, 400};

struct Drag {
  GizmoScene scene = test::plainGizmo();
  GizmoState state;

  explicit Drag(GizmoHandle handle) {
    state.axes = GizmoAxes::kWorld;
    beginDrag(state, handle, scene.placement, kPress, scene.context);
  }
  Placement to(const ViewportInput& input) { return updateDrag(state, input, scene.context).placement; }
  Placement to(const glm::vec2& pixel) { return to(pointerAt(pixel)); }
  [[nodiscard]] glm::vec3 shift(const Placement& p) const { return p.center - scene.placement.center; }
};

ViewportInput keyAt(const glm::vec2& pixel, Key key) {
  ViewportInput input = pointerAt(pixel);
  input.keysPressed = {key};
  return input;
}

ViewportInput typedAt(const glm::vec2& pixel, const std::string& text) {
  ViewportInput input = pointerAt(pixel);
  input.typed = text;
  return input;
}

TEST(GizmoKeys, AxisKeysToggleALock) {
  Drag drag(GizmoHandle::kMoveCenter);
  const glm::vec2 target = kPress + glm::vec2(60, -30);
  const glm::vec3 free = drag.shift(drag.to(target));
  for (const Key key : {Key::kX, Key::kY, Key::kZ}) {
    const int axis = static_cast<int>(key) - static_cast<int>(Key::kX);
    const glm::vec3 locked = drag.shift(drag.to(keyAt(target, key)));
    EXPECT_GT(std::abs(locked[axis]), 0.01f);
    EXPECT_NEAR(glm::length(locked), std::abs(locked[axis]), 1e-6f);
    EXPECT_LT(glm::length(drag.shift(drag.to(keyAt(target, key))) - free), 1e-6f);
  }
}

TEST(GizmoKeys, LockAppliesFromThePress) {
  Drag late(GizmoHandle::kMoveCenter);
  late.to(kPress + glm::vec2(40, 10));
  const glm::vec3 lateShift = late.shift(late.to(keyAt(kPress + glm::vec2(80, 20), Key::kX)));
  Drag early(GizmoHandle::kMoveX);
  EXPECT_LT(glm::length(early.shift(early.to(kPress + glm::vec2(80, 20))) - lateShift), 1e-5f);
}

TEST(GizmoKeys, LockChangesTheAxisOfRotationAndScale) {
  Drag turn(GizmoHandle::kRotateX);
  turn.to(keyAt(kPress, Key::kZ));
  const glm::quat rotation = turn.to(typedAt(kPress, "90")).rotation;
  EXPECT_LT(glm::length(rotation * glm::vec3(1, 0, 0) - glm::vec3(0, 1, 0)), 1e-5f);
  Drag scale(GizmoHandle::kScaleUniform);
  scale.to(keyAt(kPress, Key::kY));
  const glm::vec3 radii = scale.to(typedAt(kPress, "2")).radii;
  EXPECT_EQ(radii, scale.scene.placement.radii * glm::vec3(1, 2, 1));
}

TEST(GizmoKeys, CtrlSnapsMoveRotateAndScale) {
  for (int step = 1; step < 40; ++step) {
    const glm::vec2 target = kPress + static_cast<float>(step) * glm::vec2(4.3f, -1.7f);
    ViewportInput input = pointerAt(target);
    input.ctrl = true;
    Drag move(GizmoHandle::kMoveXY);
    const glm::vec3 steps = move.shift(move.to(input)) / (0.01f * 1.8f);
    EXPECT_LT(glm::length(steps - glm::round(steps)), 1e-3f);
    Drag turn(GizmoHandle::kRotateScreen);
    turn.to(input);
    const float angles = turn.state.drag->angle / (kHalfCircle / 12.0f);
    EXPECT_NEAR(angles, std::round(angles), 1e-4f);
    Drag scale(GizmoHandle::kScaleUniform);
    const float factor = scale.to(input).radii.x / scale.scene.placement.radii.x;
    EXPECT_NEAR(10.0f * factor, std::round(10.0f * factor), 1e-4f);
    EXPECT_GE(factor, 1.0f);
  }
}

TEST(GizmoKeys, ShiftMovesATenth) {
  Drag fast(GizmoHandle::kMoveCenter);
  Drag slow(GizmoHandle::kMoveCenter);
  ViewportInput input = pointerAt(kPress + glm::vec2(70, 40));
  const glm::vec3 whole = fast.shift(fast.to(input));
  input.shift = true;
  const glm::vec3 tenth = slow.shift(slow.to(input));
  EXPECT_LT(glm::length(10.0f * tenth - whole), 1e-5f);
  // Releasing Shift does not catch up with the pointer.
  input.shift = false;
  EXPECT_LT(glm::length(slow.shift(slow.to(input)) - tenth), 1e-6f);
}

TEST(GizmoKeys, NumbersAreEditedAndReplaceThePointer) {
  Drag drag(GizmoHandle::kMoveX);
  EXPECT_NEAR(drag.shift(drag.to(typedAt(kPress, "1"))).x, 1.0f, 1e-6f);
  EXPECT_NEAR(drag.shift(drag.to(typedAt(kPress + glm::vec2(50, 0), "2"))).x, 12.0f, 1e-5f);
  EXPECT_NEAR(drag.shift(drag.to(keyAt(kPress, Key::kBackspace))).x, 1.0f, 1e-6f);
  EXPECT_NEAR(drag.shift(drag.to(typedAt(kPress, ".5x."))).x, 1.5f, 1e-6f);
  EXPECT_NEAR(drag.shift(drag.to(typedAt(kPress, "-"))).x, -1.5f, 1e-6f);
  EXPECT_NEAR(drag.shift(drag.to(typedAt(kPress, "-"))).x, 1.5f, 1e-6f);
  EXPECT_NE(describe(drag.state).find("[1.5]"), std::string::npos);
  const glm::vec2 away = kPress + glm::vec2(50, 0);
  for (int i = 0; i < 3; ++i) drag.to(keyAt(away, Key::kBackspace));
  Drag pointer(GizmoHandle::kMoveX);
  EXPECT_LT(glm::length(drag.shift(drag.to(away)) - pointer.shift(pointer.to(away))), 1e-6f);
}

TEST(GizmoKeys, TypedNumberInAPlaneFollowsTheMotion) {
  Drag drag(GizmoHandle::kMoveXY);
  const glm::vec3 before = drag.shift(drag.to(kPress + glm::vec2(60, -40)));
  const glm::vec3 after = drag.shift(drag.to(typedAt(kPress + glm::vec2(60, -40), "0.3")));
  EXPECT_NEAR(glm::length(after), 0.3f, 1e-5f);
  EXPECT_GT(glm::dot(glm::normalize(before), glm::normalize(after)), 0.9999f);
}

TEST(GizmoKeys, TypedPoleLengthIsTheWorldSemiAxis) {
  GizmoScene scene = test::plainGizmo();
  scene.context.boneInWorld = glm::scale(glm::mat4(1.0f), glm::vec3(100.0f));
  scene.placement.center /= 100.0f;
  scene.placement.radii /= 100.0f;
  GizmoState state;
  beginDrag(state, GizmoHandle::kPoleMinusY, scene.placement, kPress, scene.context);
  const Placement after = updateDrag(state, typedAt(kPress, "0.25"), scene.context).placement;
  EXPECT_NEAR(after.radii.y, 0.0025f, 1e-8f);
  EXPECT_NEAR(after.center.y + after.radii.y, scene.placement.center.y + scene.placement.radii.y, 1e-8f);
}

TEST(GizmoKeys, RadiiStayPositive) {
  for (const GizmoHandle handle : {GizmoHandle::kScaleX, GizmoHandle::kScaleUniform, GizmoHandle::kPolePlusY}) {
    for (const glm::vec2 target : {glm::vec2(-3000, 3000), glm::vec2(3000, -3000)}) {
      Drag drag(handle);
      const glm::vec3 radii = drag.to(target).radii;
      EXPECT_TRUE(radii.x > 0 && radii.y > 0 && radii.z > 0);
      EXPECT_TRUE(isFinite(radii));
    }
    Drag drag(handle);
    const glm::vec3 radii = drag.to(typedAt(kPress, "-5")).radii;
    EXPECT_TRUE(radii.x > 0 && radii.y > 0 && radii.z > 0);
  }
}

TEST(GizmoKeys, EscapeAndTheRightButtonRestoreTheStart) {
  ViewportInput right = pointerAt(kPress + glm::vec2(90, 0));
  right.buttons[1].pressed = true;
  for (const ViewportInput& leave : {keyAt(kPress + glm::vec2(90, 0), Key::kEscape), right}) {
    Drag drag(GizmoHandle::kMoveCenter);
    EXPECT_NE(drag.to(kPress + glm::vec2(50, 20)).center, drag.scene.placement.center);
    const DragResult result = updateDrag(drag.state, leave, drag.scene.context);
    EXPECT_EQ(result.outcome, DragOutcome::kCanceled);
    EXPECT_EQ(result.placement.center, drag.scene.placement.center);
    EXPECT_FALSE(drag.state.drag.has_value());
  }
}

TEST(GizmoKeys, ReleaseIncludesTheLastMotion) {
  Drag drag(GizmoHandle::kMoveCenter);
  const glm::vec2 target = kPress + glm::vec2(30, 70);
  const DragResult result = updateDrag(drag.state, releasedAt(target), drag.scene.context);
  Drag other(GizmoHandle::kMoveCenter);
  EXPECT_EQ(result.placement.center, other.to(target).center);
}

TEST(GizmoKeys, DeltaStaysWhileTheBoneMoves) {
  Drag drag(GizmoHandle::kMoveCenter);
  const glm::vec2 target = kPress + glm::vec2(60, -30);
  const glm::vec3 before = drag.shift(drag.to(target));
  GizmoContext later = drag.scene.context;
  later.boneInWorld = glm::translate(glm::mat4(1.0f), glm::vec3(0.2f, -0.1f, 0.1f)) *
                      glm::mat4_cast(glm::angleAxis(0.8f, glm::normalize(glm::vec3(1, 2, 0.5f))));
  const Placement after = updateDrag(drag.state, pointerAt(target), later).placement;
  // World axes: the same world shift, now off the place where the bone carries the start.
  EXPECT_LT(glm::length(glm::mat3(later.boneInWorld) * drag.shift(after) - before), 1e-5f);

  Drag own(GizmoHandle::kMoveX);
  own.state.axes = GizmoAxes::kBone;
  const glm::vec3 along = own.shift(own.to(target));
  const Placement carried = updateDrag(own.state, pointerAt(target), later).placement;
  EXPECT_LT(glm::length(own.shift(carried) - along), 1e-5f);  // Bone axes: the same in bone space.
}

TEST(GizmoKeys, StatusLineDescribesTheDrag) {
  Drag drag(GizmoHandle::kMoveX);
  drag.to(typedAt(kPress, "0.12"));
  const std::string text = describe(drag.state);
  EXPECT_TRUE(text.starts_with("Move X 0.12")) << text;
  EXPECT_NE(text.find("Esc cancels"), std::string::npos);
  GizmoState hovering;
  EXPECT_EQ(describe(hovering), "");
  hovering.hovered = GizmoHandle::kPoleMinusZ;
  EXPECT_NE(describe(hovering).find("-Z"), std::string::npos);
}

}  // namespace
}  // namespace sinew::app
