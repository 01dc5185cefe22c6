// tests/viewport/tools/pose_bone_test.cpp: a joint follows the dragged ring in the world, whatever its bone's frame.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "tests/support/editor/muscles_named.h"
#include "tests/viewport/tools/limb_scene.h"

namespace sinew::app {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180.0f;
constexpr int kMiddle = 1;

/// The limb with the pose tool; the pose follows the overrides as in the editor.
struct PoseScene : test::LimbScene {
  PoseOverrides overrides;
  Pose moment;

  PoseScene() {
    moment = pose;
    setTool(tools, ToolKind::kPose);
    document.selection.bone = kMiddle;
  }
  RouteResult step(const ViewportInput& input) {
    pose = posed(document.character->skeleton, moment, overrides);
    ViewportContext now = context();
    now.overrides = &overrides;
    return routeInput(tools, input, now);
  }
  RouteResult mouse(const glm::vec2& pixel, bool down, ViewportInput with = {}) {
    with.mouse = pixel;
    with.buttons[0].pressed = down && !held;
    with.buttons[0].released = !down && held;
    with.buttons[0].down = down;
    held = down;
    return step(with);
  }
  /// Grabs a ring, types degrees, releases it.
  void typeTurn(const char* ring, const std::string& degrees, bool keep = true) {
    const glm::vec2 at = mouse({1, 1}, false).gizmo.namedPixels().at(ring);
    mouse(at, false);
    mouse(at, true);
    for (const char c : degrees) {
      ViewportInput input;
      input.typed = std::string(1, c);
      mouse(at, true, input);
    }
    ViewportInput last;
    last.keysPressed = {keep ? Key::kEnter : Key::kEscape};
    mouse(at, true, last);
    mouse(at, false);
    mouse({1, 1}, false);
  }
  [[nodiscard]] glm::mat3 turned(int bone) const {
    const auto i = static_cast<std::size_t>(bone);
    return turnFrame(pose.boneInWorld[i]) * glm::transpose(turnFrame(moment.boneInWorld[i]));
  }
  bool held = false;
};

float angleOf(const glm::mat3& rotation) {
  const glm::quat q = glm::quat_cast(rotation);
  return 2.0f * std::atan2(glm::length(glm::vec3(q.x, q.y, q.z)), std::abs(q.w)) / kDegree;
}

TEST(PoseTool, ShowsOnlyRingsAtTheSelectedJoint) {
  PoseScene scene;
  const RouteResult route = scene.mouse({1, 1}, false);
  ASSERT_TRUE(route.gizmo.visible);
  const glm::vec3 joint = route.view.toPixel(glm::vec3(scene.pose.boneInWorld[kMiddle][3]));
  EXPECT_LT(glm::length(route.gizmo.origin - glm::vec2(joint)), 0.5f);
  EXPECT_TRUE(route.gizmo.namedPixels().contains("rotate.x"));
  for (const auto& [name, pixel] : route.gizmo.namedPixels()) EXPECT_TRUE(name.starts_with("rotate")) << name;
  scene.document.selection.bone = -1;
  EXPECT_FALSE(scene.mouse({1, 1}, false).gizmo.visible);
}

TEST(PoseTool, TypedAngleRotatesAboutTheWorldAxis) {
  for (const char* ring : {"rotate.x", "rotate.y", "rotate.z"}) {
    PoseScene scene;
    // A frame of its own, so that the world's axes differ from the bone's.
    scene.moment.boneInWorld[kMiddle] =
        scene.moment.boneInWorld[kMiddle] * glm::mat4_cast(glm::angleAxis(0.9f, glm::normalize(glm::vec3(1, 2, 3))));
    scene.tools.gizmo.axes = GizmoAxes::kWorld;
    scene.typeTurn(ring, "37");
    glm::vec3 axis(0.0f);
    axis[ring[7] - 'x'] = 1.0f;
    const glm::mat3 expected = glm::mat3_cast(glm::angleAxis(37.0f * kDegree, axis));
    for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(scene.turned(kMiddle)[c] - expected[c]), 1e-4f) << ring;
    scene.typeTurn(ring, "20");  // Rotations add up.
    EXPECT_NEAR(angleOf(scene.turned(kMiddle)), 57.0f, 0.01f) << ring;
  }
}

TEST(PoseTool, BoneAxesRotateWithTheJoint) {
  PoseScene scene;
  scene.tools.gizmo.axes = GizmoAxes::kBone;
  scene.typeTurn("rotate.x", "50");
  const glm::vec3 own = turnFrame(scene.pose.boneInWorld[kMiddle])[2];
  scene.typeTurn("rotate.z", "30");
  EXPECT_LT(glm::length(turnFrame(scene.pose.boneInWorld[kMiddle])[2] - own), 1e-4f);
}

TEST(PoseTool, EscapeRestoresTheOverrides) {
  PoseScene scene;
  scene.typeTurn("rotate.x", "25");
  const PoseOverrides before = scene.overrides;
  scene.typeTurn("rotate.z", "80", false);
  EXPECT_EQ(scene.overrides, before);
  EXPECT_FALSE(scene.tools.gizmo.drag.has_value());
  EXPECT_EQ(scene.tools.owner, PressOwner::kNone);
}

TEST(PoseTool, RingFollowsThePointerDuringPlayback) {
  PoseScene scene;
  scene.tools.gizmo.axes = GizmoAxes::kWorld;
  const RouteResult route = scene.mouse({1, 1}, false);
  const HandleShape* ring = route.gizmo.find(GizmoHandle::kRotateScreen);
  ASSERT_TRUE(ring);
  const glm::vec2 from = ring->anchor;
  const glm::vec2 center = route.gizmo.origin;
  const auto at = [&](float angle) {
    const glm::vec2 arm = from - center;
    return center + glm::vec2(arm.x * std::cos(angle) - arm.y * std::sin(angle),
                              arm.x * std::sin(angle) + arm.y * std::cos(angle));
  };
  scene.mouse(from, false);
  scene.mouse(from, true);
  // The clip rotates the joint too; the 40 degrees by hand come on top.
  for (int i = 1; i <= 10; ++i) {
    scene.moment.boneInWorld[kMiddle] *= glm::mat4_cast(glm::angleAxis(0.05f, glm::vec3(0, 1, 0)));
    scene.mouse(at(4.0f * static_cast<float>(i) * kDegree), true);
  }
  scene.mouse(at(40.0f * kDegree), false);
  scene.mouse({1, 1}, false);
  EXPECT_NEAR(angleOf(scene.turned(kMiddle)), 40.0f, 0.5f);
  ASSERT_EQ(scene.overrides.turns.size(), 1u);
  EXPECT_EQ(scene.overrides.turns[0].bone, kMiddle);
}

TEST(PoseTool, HeldJointDoesNotJumpWhenGrabbed) {
  PoseScene scene;
  scene.moment.boneInWorld[kMiddle] *= glm::mat4_cast(glm::angleAxis(0.8f, glm::vec3(1, 0, 0)));
  scene.overrides.from = TurnsFrom::kBindPose;
  scene.typeTurn("rotate.z", "10");
  EXPECT_NEAR(angleOf(scene.turned(kMiddle)), 10.0f, 0.01f);
  scene.typeTurn("rotate.x", "60", false);
  EXPECT_NEAR(angleOf(scene.turned(kMiddle)), 10.0f, 0.01f);
}

TEST(PoseTool, ClickSelectsTheJointAndKeepsTheMuscle) {
  PoseScene scene;
  scene.document.selection.set(PrimitiveId{77});
  const RouteResult route = scene.mouse({1, 1}, false);
  const glm::vec2 end(route.view.toPixel(glm::vec3(scene.pose.boneInWorld[2][3])));
  // Slightly off: joints have a pick radius, and can be picked through the skin.
  scene.mouse(end + glm::vec2(3, -3), false);
  EXPECT_EQ(scene.tools.hover.bone, 2);
  scene.mouse(end + glm::vec2(3, -3), true);
  scene.mouse(end + glm::vec2(3, -3), false);
  EXPECT_EQ(scene.document.selection.bone, 2);
  EXPECT_EQ(scene.document.selection.primitives.size(), 1u);
  EXPECT_TRUE(scene.overrides.isEmpty());
  EXPECT_EQ(scene.document.commands.position(), 0u) << "choosing a joint is no step";
}

TEST(PoseTool, GizmoIsHiddenWithoutOverrides) {
  test::LimbScene scene;
  setTool(scene.tools, ToolKind::kPose);
  scene.document.selection.bone = kMiddle;
  EXPECT_FALSE(scene.move({500, 400}).gizmo.visible);
}

}  // namespace
}  // namespace sinew::app
