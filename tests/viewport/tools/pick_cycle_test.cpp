// tests/viewport/tools/pick_cycle_test.cpp: repeated clicks cycle through the objects behind each other.
#include "app/viewport/tools/pick_cycle.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/viewport/tools/limb_scene.h"

namespace sinew::app {
namespace {

using test::LimbScene;

/// The limb with balls along the view: "a" nearest, all partly or wholly behind each other; seen from the front.
struct Row : LimbScene {
  explicit Row(int count = 3) {
    tools.camera.stand.yaw = tools.camera.stand.pitch = 0.0f;
    setTool(tools, ToolKind::kSelect);
    display.primitives = true;
    Rig rig;
    for (int i = 0; i < count; ++i) {
      Primitive ball;
      ball.name = std::string(1, static_cast<char>('a' + i));
      ball.bone = "middle";
      const int bone = *document.character->skeleton.findBone("middle");
      const glm::mat4 inBone = glm::inverse(pose.boneInWorld[static_cast<std::size_t>(bone)]);
      const glm::vec3 at(0.0f, 1.0f, 1.5f - 0.5f * static_cast<float>(i));
      ball.placement = {glm::vec3(inBone * glm::vec4(at, 1.0f)), {1, 0, 0, 0}, glm::vec3(0.2f)};
      rig = addPrimitive(rig, ball).value();
    }
    document.commands.apply("Set up", rig);
    // Clear of the handles at the middle and the poles.
    pixel = glm::vec2(viewOf(tools.camera, kSize).toPixel({0, 1, 0})) + glm::vec2(17, 13);
  }
  RouteResult clickAgain(const glm::vec2& off = glm::vec2(0.0f), ViewportInput with = {}) {
    return click(pixel + off, std::move(with));
  }
  [[nodiscard]] std::string active() const { return document.activeName(); }
  [[nodiscard]] std::string aimed() const {
    return tools.hover.primitive < 0 ? ""
                                     : document.rig().primitives[static_cast<std::size_t>(tools.hover.primitive)].name;
  }
  glm::vec2 pixel{0.0f};
};

TEST(PickCycle, ClicksCycleThroughAll) {
  Row row(5);
  std::string names;
  for (int i = 0; i < 10; ++i) {
    const RouteResult result = row.clickAgain();
    names += row.active();
    EXPECT_EQ(result.status.find(std::to_string(i % 5 + 1) + " of 5 here"), 0u) << result.status;
  }
  EXPECT_EQ(names, "abcdeabcde");
}

TEST(PickCycle, HoverPredictsTheClick) {
  Row row;
  row.move(row.pixel);
  for (int i = 0; i < 7; ++i) {
    const std::string aimed = row.aimed();
    row.clickAgain();
    EXPECT_EQ(row.active(), aimed);
  }
}

TEST(PickCycle, SmallMotionContinuesTheCycle) {
  Row row;
  row.clickAgain();
  row.clickAgain({2, 1});
  EXPECT_EQ(row.active(), "b");
  row.clickAgain({0, 9});
  EXPECT_EQ(row.active(), "a");
}

TEST(PickCycle, CameraPoseRigOrSelectionChangeRestartsIt) {
  const auto after = [](const auto& change) {
    Row row;
    row.clickAgain();
    change(row);
    row.clickAgain();
    return row.active();
  };
  EXPECT_EQ(after([](Row&) {}), "b");
  EXPECT_EQ(after([](Row& row) { row.tools.camera.stand.yaw += 0.001f; }), "a");
  EXPECT_EQ(after([](Row& row) {
              row.pose.boneInWorld[0] = glm::translate(row.pose.boneInWorld[0], {0, 0.001f, 0});
            }),
            "a");
  EXPECT_EQ(after([](Row& row) { row.document.selection.clear(); }), "a");
  EXPECT_EQ(after([](Row& row) { row.document.selection.set(row.document.idAt(2)); }), "a");
  EXPECT_EQ(after([](Row& row) {
              Rig rig = row.document.rig();
              rig.primitives[2].placement.center.x += 0.01f;
              row.document.commands.apply("Move", rig);
            }),
            "a");
  EXPECT_EQ(after([](Row& row) { row.document.visibility.setMuscle(Mark::kHidden, row.document.idAt(1), true); }), "a");
}

TEST(PickCycle, PlaybackKeepsTheOrder) {
  Row row;
  std::string names;
  for (int i = 0; i < 6; ++i) {
    // The balls swing, which changes their order along the ray; the list stays as first found.
    const float turn = 0.05f * static_cast<float>(i % 3);
    row.pose = bindPose(row.document.character->skeleton);
    for (glm::mat4& bone : row.pose.boneInWorld) bone = glm::rotate(glm::mat4(1), turn, glm::vec3(0, 1, 0)) * bone;
    ViewportContext context = row.context();
    context.playing = true;
    for (const bool down : {true, false}) {
      ViewportInput input = LimbScene::at(row.pixel);
      input.buttons[0] = {down, down, !down, false};
      routeInput(row.tools, input, context);
    }
    names += row.active();
  }
  EXPECT_EQ(names, "abcabc");
}

TEST(PickCycle, ShiftTogglesTheFirstMuscle) {
  Row row;
  row.clickAgain();
  row.clickAgain();
  EXPECT_EQ(row.active(), "b");
  ViewportInput shift;
  shift.shift = true;
  row.clickAgain({}, shift);
  EXPECT_EQ(row.active(), "a");
  EXPECT_EQ(row.document.selection.primitives.size(), 2u);
  row.clickAgain({}, shift);
  EXPECT_EQ(row.active(), "b");
  EXPECT_EQ(row.document.selection.primitives.size(), 1u);
}

TEST(PickCycle, HandlePassesClicksButNotDrags) {
  Row row;
  setTool(row.tools, ToolKind::kMove);
  row.pixel = glm::vec2(viewOf(row.tools.camera, LimbScene::kSize).toPixel({0, 1, 1.5f}));
  row.clickAgain();
  ASSERT_EQ(row.active(), "a");
  row.move(row.pixel);
  ASSERT_NE(row.tools.gizmo.hovered, GizmoHandle::kNone) << "a handle stands where the muscle was clicked";
  row.clickAgain();
  EXPECT_EQ(row.active(), "b");
  EXPECT_EQ(row.document.commands.position(), 1u) << "no step";
  row.move(row.pixel);
  row.press(row.pixel);
  row.drag(row.pixel + glm::vec2(20, 0));
  row.release(row.pixel + glm::vec2(20, 0));
  EXPECT_EQ(row.active(), "b");
  EXPECT_EQ(row.document.commands.position(), 2u);
}

TEST(ViewportMenu, RightClickOpensItAndARightDragPans) {
  Row row;
  row.move(row.pixel);
  row.press(row.pixel, MouseButton::kRight);
  const RouteResult clicked = row.release(row.pixel, MouseButton::kRight);
  ASSERT_TRUE(clicked.menu);
  ASSERT_EQ(clicked.menu->here.size(), 3u);
  EXPECT_EQ(clicked.menu->here[0].muscle, row.document.idAt(0));
  EXPECT_TRUE(clicked.needsFrame);

  const glm::vec3 target = row.tools.camera.stand.target;
  row.press(row.pixel, MouseButton::kRight);
  row.drag(row.pixel + glm::vec2(30, 0), MouseButton::kRight);
  row.drag(row.pixel, MouseButton::kRight);
  EXPECT_FALSE(row.release(row.pixel, MouseButton::kRight).menu) << "a drag that comes back is a drag";
  EXPECT_EQ(row.tools.camera.stand.distance, Row().tools.camera.stand.distance);
  row.press(row.pixel, MouseButton::kRight);
  row.drag(row.pixel + glm::vec2(30, 0), MouseButton::kRight);
  row.release(row.pixel + glm::vec2(30, 0), MouseButton::kRight);
  EXPECT_NE(row.tools.camera.stand.target, target);
}

TEST(ViewportMenu, CancelingRightButtonDoesNotOpenIt) {
  Row row;
  setTool(row.tools, ToolKind::kMove);
  row.clickAgain();
  row.move(row.pixel);
  row.press(row.pixel);
  row.drag(row.pixel + glm::vec2(40, 0));
  row.press(row.pixel + glm::vec2(40, 0), MouseButton::kRight);
  EXPECT_FALSE(row.tools.gizmo.drag);
  EXPECT_FALSE(row.release(row.pixel + glm::vec2(40, 0), MouseButton::kRight).menu);
  armBox(row.tools);
  row.press(row.pixel, MouseButton::kRight);
  EXPECT_FALSE(row.tools.box.armed);
  EXPECT_FALSE(row.release(row.pixel, MouseButton::kRight).menu);
}

TEST(ViewportMenu, AppliesToTheSelectedOfSeveralMuscles) {
  Row row;
  row.clickAgain();
  row.clickAgain();
  row.press(row.pixel, MouseButton::kRight);
  const RouteResult clicked = row.release(row.pixel, MouseButton::kRight);
  ASSERT_TRUE(clicked.menu);
  EXPECT_EQ(clicked.menu->here[clicked.menu->at].muscle, row.document.idAt(1));
}

}  // namespace
}  // namespace sinew::app
