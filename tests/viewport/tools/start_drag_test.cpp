// tests/viewport/tools/start_drag_test.cpp: a drag started from the keyboard: no button, a click confirms it.

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/viewport/tools/limb_scene.h"

namespace sinew::app {
namespace {

using test::LimbScene;

struct MuscleOnLimb : LimbScene {
  MuscleOnLimb() {
    static_cast<void>(addMuscleOnBone(document, 1));
    smooth();
    move(kBegin);
  }
  [[nodiscard]] const Placement& placement() const { return document.rig().primitives[0].placement; }
  [[nodiscard]] std::size_t steps() const { return document.commands.stepCount(); }
  static constexpr glm::vec2 kBegin{500, 400};
};

TEST(StartDrag, GrabFollowsThePointerAndAClickCommits) {
  MuscleOnLimb scene;
  const Placement start = scene.placement();
  startDrag(scene.tools, ToolKind::kMove);
  const glm::vec2 origin = scene.move(scene.kBegin).gizmo.origin;
  EXPECT_TRUE(ownsKeyboard(scene.tools));
  const RouteResult moved = scene.move(scene.kBegin + glm::vec2(60, -25));
  EXPECT_LT(glm::length(moved.gizmo.origin - origin - glm::vec2(60, -25)), 1.5f);
  EXPECT_TRUE(scene.document.commands.inGesture());
  scene.press(scene.kBegin + glm::vec2(60, -25));
  EXPECT_FALSE(ownsKeyboard(scene.tools));
  scene.release(scene.kBegin + glm::vec2(60, -25));
  EXPECT_EQ(scene.steps(), 2u);  // Added, moved.
  EXPECT_NE(scene.placement().center, start.center);
  EXPECT_EQ(scene.document.selection.primitives.size(), 1u);
  const Placement kept = scene.placement();
  scene.move({100, 100});
  EXPECT_EQ(scene.placement().center, kept.center);
}

TEST(StartDrag, EveryToolChangesItsOwnProperty) {
  for (const ToolKind tool : {ToolKind::kMove, ToolKind::kRotate, ToolKind::kScale}) {
    MuscleOnLimb scene;
    const Placement start = scene.placement();
    scene.move({640, 300});  // Off the middle, so that a rotation has an angle.
    startDrag(scene.tools, tool);
    scene.move({640, 300});
    scene.move({660, 400});
    scene.move({640, 480});
    scene.click({640, 480});
    EXPECT_EQ(scene.steps(), 2u) << nameOf(tool);
    EXPECT_EQ(scene.placement().center != start.center, tool == ToolKind::kMove);
    EXPECT_EQ(scene.placement().rotation != start.rotation, tool == ToolKind::kRotate);
    EXPECT_EQ(scene.placement().radii != start.radii, tool == ToolKind::kScale);
    EXPECT_EQ(scene.tools.tool, tool);
  }
}

TEST(StartDrag, EscapeAndTheRightButtonCancel) {
  for (const bool escape : {true, false}) {
    MuscleOnLimb scene;
    const Placement start = scene.placement();
    const CameraStand stand = scene.tools.camera.stand;
    startDrag(scene.tools, ToolKind::kMove);
    scene.move(scene.kBegin);
    scene.move(scene.kBegin + glm::vec2(60, 0));
    EXPECT_NE(scene.placement().center, start.center);
    if (escape) {
      ViewportInput input = scene.at(scene.kBegin + glm::vec2(60, 0));
      input.keysPressed = {Key::kEscape};
      scene.frame(input);
    } else {
      scene.press(scene.kBegin + glm::vec2(60, 0), MouseButton::kRight);
    }
    EXPECT_FALSE(ownsKeyboard(scene.tools));
    scene.move(scene.kBegin + glm::vec2(90, 30));
    EXPECT_EQ(scene.placement().center, start.center);
    EXPECT_EQ(scene.steps(), 1u);
    EXPECT_TRUE(test::sameStand(stand, scene.tools.camera.stand));
  }
}

TEST(StartDrag, TypedNumberAndEnterAreExact) {
  MuscleOnLimb scene;
  scene.tools.gizmo.axes = GizmoAxes::kBone;
  const Placement start = scene.placement();
  startDrag(scene.tools, ToolKind::kMove);
  scene.move(scene.kBegin);
  ViewportInput input = scene.at(scene.kBegin + glm::vec2(10, 0));
  input.keysPressed = {Key::kX};
  scene.frame(input);
  input.keysPressed.clear();
  input.typed = "0.25";
  scene.frame(input);
  input.typed.clear();
  input.keysPressed = {Key::kEnter};
  scene.frame(input);
  EXPECT_NEAR(std::abs(scene.placement().center.x - start.center.x), 0.25f, 1e-5f);
  EXPECT_FLOAT_EQ(scene.placement().center.y, start.center.y);
  EXPECT_FALSE(ownsKeyboard(scene.tools));
}

TEST(StartDrag, DoesNotStartWithoutASelectionOrOutsideTheViewport) {
  MuscleOnLimb scene;
  startDrag(scene.tools, ToolKind::kMove);
  scene.move({-20, 100});
  scene.move(scene.kBegin);  // It does not start later either.
  EXPECT_FALSE(ownsKeyboard(scene.tools));
  scene.document.selection.clear();
  startDrag(scene.tools, ToolKind::kRotate);
  scene.move(scene.kBegin);
  EXPECT_FALSE(ownsKeyboard(scene.tools));
  EXPECT_EQ(scene.tools.tool, ToolKind::kRotate);
  EXPECT_EQ(scene.steps(), 1u);
}

}  // namespace
}  // namespace sinew::app
