// tests/viewport/tools/input_router_test.cpp: a press belongs to one layer.

#include "app/viewport/tools/input_router.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/editor/muscles_named.h"
#include "tests/viewport/tools/limb_scene.h"

namespace sinew::app {
namespace {

using test::LimbScene;
using test::sameStand;

/// A limb with one selected muscle on its middle bone, under the gizmo.
struct GizmoOnLimb : LimbScene {
  GizmoOnLimb() {
    static_cast<void>(addMuscleOnBone(document, 1));
    smooth();
  }
  [[nodiscard]] glm::vec2 handlePixel(GizmoHandle handle) {
    const RouteResult result = move({5, 5});
    const HandleShape* shape = result.gizmo.find(handle);
    EXPECT_NE(shape, nullptr) << nameOf(handle);
    return shape ? shape->anchor : glm::vec2(0.0f);
  }
  [[nodiscard]] const Placement& placement() const { return document.rig().primitives[0].placement; }
};

TEST(InputRouter, GizmoDragIsOneStepAndKeepsTheCamera) {
  GizmoOnLimb scene;
  const CameraStand before = scene.tools.camera.stand;
  const Placement start = scene.placement();
  const glm::vec2 pixel = scene.handlePixel(GizmoHandle::kMoveCenter);
  EXPECT_NE(scene.move(pixel).status.find("move"), std::string::npos);
  EXPECT_EQ(scene.tools.gizmo.hovered, GizmoHandle::kMoveCenter);
  scene.press(pixel);
  EXPECT_TRUE(ownsKeyboard(scene.tools));
  for (int i = 1; i <= 5; ++i) EXPECT_TRUE(scene.drag(pixel + static_cast<float>(i) * glm::vec2(10, 4)).needsFrame);
  scene.release(pixel + glm::vec2(50, 20));
  EXPECT_FALSE(ownsKeyboard(scene.tools));
  EXPECT_NE(scene.placement().center, start.center);
  EXPECT_EQ(scene.document.commands.stepCount(), 2u);  // Added, moved.
  EXPECT_TRUE(sameStand(before, scene.tools.camera.stand));
  scene.document.commands.undo();
  EXPECT_EQ(scene.placement().center, start.center);
}

TEST(InputRouter, GizmoFollowsThePointerInTheSameFrame) {
  GizmoOnLimb scene;
  const glm::vec2 pixel = scene.handlePixel(GizmoHandle::kMoveCenter);
  scene.move(pixel);
  scene.press(pixel);
  const RouteResult result = scene.drag(pixel + glm::vec2(37, -21));
  EXPECT_LT(glm::length(result.gizmo.origin - (pixel + glm::vec2(37, -21))), 1.5f);
}

TEST(InputRouter, ClickOnAHandleMakesNoStep) {
  GizmoOnLimb scene;
  scene.click(scene.handlePixel(GizmoHandle::kMoveX));
  EXPECT_EQ(scene.document.commands.stepCount(), 1u);
  EXPECT_EQ(scene.document.selection.primitives.size(), 1u);
}

TEST(InputRouter, EscapeCancelsAndTheRestOfThePressIsIgnored) {
  GizmoOnLimb scene;
  const CameraStand before = scene.tools.camera.stand;
  const Placement start = scene.placement();
  const glm::vec2 pixel = scene.handlePixel(GizmoHandle::kMoveX);
  scene.move(pixel);
  scene.press(pixel);
  scene.drag(pixel + glm::vec2(40, 0));
  ViewportInput escape;
  escape.keysPressed = {Key::kEscape};
  scene.drag(pixel + glm::vec2(50, 0), MouseButton::kLeft, escape);
  EXPECT_EQ(scene.placement().center, start.center);
  scene.drag(pixel + glm::vec2(90, 0));
  scene.release(pixel + glm::vec2(90, 0));
  EXPECT_TRUE(sameStand(before, scene.tools.camera.stand));
  EXPECT_EQ(scene.document.commands.stepCount(), 1u);
  EXPECT_EQ(scene.document.selection.primitives.size(), 1u);
}

TEST(InputRouter, LostReleaseCommitsTheDrag) {
  GizmoOnLimb scene;
  const Placement start = scene.placement();
  const glm::vec2 pixel = scene.handlePixel(GizmoHandle::kMoveCenter);
  scene.move(pixel);
  scene.press(pixel);
  scene.drag(pixel + glm::vec2(30, 0));
  scene.move(pixel + glm::vec2(30, 0));  // The button was released without an event.
  EXPECT_FALSE(scene.document.commands.inGesture());
  EXPECT_NE(scene.placement().center, start.center);
}

TEST(InputRouter, UndoDuringADragEndsIt) {
  GizmoOnLimb scene;
  const Placement start = scene.placement();
  const glm::vec2 pixel = scene.handlePixel(GizmoHandle::kMoveCenter);
  scene.move(pixel);
  scene.press(pixel);
  scene.drag(pixel + glm::vec2(30, 0));
  scene.document.commands.undo();
  scene.drag(pixel + glm::vec2(60, 0));
  scene.release(pixel + glm::vec2(60, 0));
  EXPECT_FALSE(ownsKeyboard(scene.tools));
  ASSERT_FALSE(scene.document.rig().primitives.empty());
  EXPECT_EQ(scene.placement().center, start.center);
}

TEST(InputRouter, PanelsOwnThePressUntilItsRelease) {
  LimbScene scene;
  const CameraStand before = scene.tools.camera.stand;
  ViewportInput taken;
  taken.mouseTaken = true;
  taken.wheel = 1.0f;
  scene.press({500, 400}, MouseButton::kLeft, taken);
  scene.drag({600, 400});
  scene.drag({700, 300});
  scene.release({700, 300});
  EXPECT_TRUE(sameStand(before, scene.tools.camera.stand));
  EXPECT_EQ(scene.document.selection.bone, -1);
}

TEST(InputRouter, CameraButtonsOrbitAndPan) {
  struct Case {
    MouseButton button;
    bool alt, shift, pans;
  };
  for (const Case& c : {Case{MouseButton::kLeft, false, false, false}, Case{MouseButton::kLeft, true, false, false},
                        Case{MouseButton::kMiddle, false, false, false}, Case{MouseButton::kMiddle, false, true, true},
                        Case{MouseButton::kRight, false, false, true}}) {
    GizmoOnLimb scene;
    const CameraStand before = scene.tools.camera.stand;
    ViewportInput with;
    with.alt = c.alt;
    with.shift = c.shift;
    // Alt orbits even from a handle; the others start on the background.
    const glm::vec2 from = c.alt ? scene.handlePixel(GizmoHandle::kMoveX) : glm::vec2(40, 60);
    scene.frame([&] {
      ViewportInput input = with;
      input.mouse = from;
      return input;
    }());
    scene.press(from, c.button, with);
    scene.drag(from + glm::vec2(15, 5), c.button, with);
    scene.drag(from + glm::vec2(60, 25), c.button, with);
    scene.release(from + glm::vec2(60, 25), c.button, with);
    const CameraStand after = scene.tools.camera.stand;
    EXPECT_EQ(after.target != before.target, c.pans);
    EXPECT_EQ(after.yaw != before.yaw, !c.pans);
    EXPECT_EQ(after.distance, before.distance);
    EXPECT_EQ(scene.document.commands.stepCount(), 1u);
    EXPECT_EQ(scene.document.selection.primitives.size(), 1u) << "a drag is no click";
    // All of the motion counts, including the part before the drag threshold.
    Camera whole = scene.tools.camera;
    whole.stand = before;
    if (c.pans) pan(whole, {60, 25}, LimbScene::kSize);
    else orbit(whole, {60, 25}, LimbScene::kSize);
    EXPECT_NEAR(after.yaw, whole.stand.yaw, 1e-5f);
    EXPECT_LT(glm::length(after.target - whole.stand.target), 1e-5f);
  }
}

TEST(InputRouter, WheelKeepsTheSkinUnderThePointer) {
  LimbScene scene;
  const glm::vec2 pixel = scene.skinPixel();
  scene.move(pixel);
  ASSERT_TRUE(scene.tools.hover.any());
  const glm::vec3 point = scene.tools.hover.pointInWorld;
  ViewportInput input = LimbScene::at(pixel);
  input.wheel = 3.0f;
  const RouteResult result = scene.frame(input);
  EXPECT_LT(glm::length(glm::vec2(result.view.toPixel(point)) - pixel), 0.5f);
}

TEST(InputRouter, ClicksSelectMusclesOrBonesOrClear) {
  GizmoOnLimb scene;
  scene.document.selection.clear();
  scene.click(scene.skinPixel());
  EXPECT_EQ(scene.document.activeName(), scene.document.rig().primitives[0].name);
  scene.click({5, 5});
  EXPECT_TRUE(scene.document.selection.primitives.empty());

  LimbScene bare;
  bare.click(bare.skinPixel());
  EXPECT_GE(bare.document.selection.bone, 0);
  bare.click({5, 5});
  EXPECT_EQ(bare.document.selection.bone, -1);
}

TEST(InputRouter, ShiftTogglesAndNeverClears) {
  GizmoOnLimb scene;
  setTool(scene.tools, ToolKind::kSelect);
  scene.document.selection.clear();
  scene.document.selection.set(PrimitiveId{77});
  ViewportInput shift;
  shift.shift = true;
  scene.display.primitives = true;
  scene.click(scene.skinPixel(), shift);
  EXPECT_EQ(scene.document.selection.primitives.size(), 2u);
  scene.click({5, 5}, shift);
  EXPECT_EQ(scene.document.selection.primitives.size(), 2u);
}

TEST(InputRouter, ToolChangeEndsTheDrag) {
  GizmoOnLimb scene;
  const glm::vec2 pixel = scene.handlePixel(GizmoHandle::kMoveX);
  scene.move(pixel);
  scene.press(pixel);
  setTool(scene.tools, ToolKind::kAddMuscle);
  EXPECT_EQ(scene.tools.tool, ToolKind::kMove);
  cancelDrags(scene.tools, scene.document);
  EXPECT_FALSE(scene.document.commands.inGesture());
  setTool(scene.tools, ToolKind::kRotate);
  EXPECT_EQ(scene.tools.gizmo.mode, GizmoMode::kRotate);
  EXPECT_NE(scene.move({5, 5}).gizmo.find(GizmoHandle::kRotateScreen), nullptr);
  setTool(scene.tools, ToolKind::kAddMuscle);
  EXPECT_FALSE(scene.move({5, 5}).gizmo.visible) << "the skin is free to be pressed";
}

TEST(InputRouter, HoveredMuscleCanBeRemoved) {
  GizmoOnLimb scene;
  scene.document.selection.clear();
  scene.move(scene.skinPixel());
  ASSERT_EQ(scene.tools.hover.primitive, 0);
  scene.document.commands.undo();
  const RouteResult result = scene.move(scene.skinPixel());
  EXPECT_EQ(scene.tools.hover.primitive, -1);
  EXPECT_NE(result.status.find("Bone"), std::string::npos);
}

TEST(InputRouter, UnattachedMuscleHasNoGizmo) {
  GizmoOnLimb scene;
  Rig rig = scene.document.rig();
  rig.primitives[0].bone = "nowhere";
  scene.document.commands.apply("Rename", rig);
  EXPECT_FALSE(scene.move({5, 5}).gizmo.visible);
}

}  // namespace
}  // namespace sinew::app
