// tests/viewport/tools/add_muscle_test.cpp: a drawn muscle has the stroke's position, direction and size.

#include "app/viewport/tools/add_muscle.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/characters/real_characters.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/viewport/tools/limb_scene.h"
#include "tests/viewport/tools/random_gizmo.h"

namespace sinew::app {
namespace {

using test::BoneScale;
using test::LimbScene;
using test::Random;

/// Largest extent of the world ellipsoid along a unit direction, from its center.
float extentAlong(const glm::mat4& shape, const glm::vec3& direction) {
  return glm::length(glm::transpose(glm::mat3(shape)) * direction);
}

/// A stroke from `start` straight along its tangent plane.
SkinStroke straightStroke(const SkinPoint& start, const glm::vec3& drag) {
  return {{start, {start.point + drag, start.normal}}};
}

TEST(PlacementOnSkin, LiesAlongTheStrokeHalfBuried) {
  Random random(51);
  for (int i = 0; i < 300; ++i) {
    const float height = i % 2 ? 1.8f : 155.0f;
    const glm::mat4 bone = test::randomBone(random, static_cast<BoneScale>(i % 3), height);
    const SkinPoint start{height * glm::vec3(random.uniform(-1, 1), random.uniform(0, 1), 0.2f),
                          random.rotation() * glm::vec3(0, 0, 1)};
    glm::vec3 drag = random.rotation() * glm::vec3(random.uniform(0.05f, 0.4f) * height, 0, 0);
    drag -= glm::dot(drag, start.normal) * start.normal;
    if (glm::length(drag) < 0.04f * height) continue;
    const Placement placement = placementOnSkin(straightStroke(start, drag), bone, glm::vec3(0, 1, 0), height);
    const glm::mat4 shape = shapeInWorld(placement, 1.0f, bone);

    EXPECT_NEAR(glm::length(placement.rotation), 1.0f, 1e-5f);
    const glm::vec3 longAxis(shape[0]);
    EXPECT_GT(std::abs(glm::dot(glm::normalize(longAxis), glm::normalize(drag))), 0.9999f) << i;
    EXPECT_NEAR(glm::length(longAxis), 0.5f * glm::length(drag), 0.001f * height);
    const glm::vec3 center(shape[3]);
    const float depth = glm::dot(center - start.point, start.normal);
    const float thickness = extentAlong(shape, start.normal);
    EXPECT_LT(depth, 0.0f) << "below the skin";
    EXPECT_GT(depth + thickness, 0.5f * thickness) << "yet out of it";
    EXPECT_LT(glm::length(center - (start.point + 0.5f * drag)), 0.06f * height);
    EXPECT_GT(glm::dot(glm::vec3(shape[2]), start.normal), 0.0f);
  }
}

TEST(PlacementOnSkin, ClickAlignsWithTheBone) {
  Random random(52);
  for (int i = 0; i < 100; ++i) {
    const glm::mat4 bone = test::randomBone(random, static_cast<BoneScale>(i % 3), 1.8f);
    const SkinPoint start{glm::vec3(0.1f, 0.9f, 0.2f), random.rotation() * glm::vec3(0, 0, 1)};
    const glm::vec3 axis = random.rotation() * glm::vec3(0.3f, 0, 0);
    const glm::mat4 shape = shapeInWorld(placementOnSkin({{start}}, bone, axis, 1.8f), 1.0f, bone);
    const glm::vec3 flat = axis - glm::dot(axis, start.normal) * start.normal;
    if (glm::length(flat) < 0.02f) continue;
    EXPECT_GT(glm::dot(glm::normalize(glm::vec3(shape[0])), glm::normalize(flat)), 0.999f);
    EXPECT_NEAR(glm::length(glm::vec3(shape[0])), 0.05f * 1.8f, 1e-4f);
  }
}

/// A stroke along an arc in the XY plane around the origin, symmetric about +Y. `outward` -1: seen from inside.
SkinStroke arcStroke(float radius, float angle, float outward) {
  SkinStroke stroke;
  for (int i = 0; i <= 64; ++i) {
    const float at = angle * (static_cast<float>(i) / 64.0f - 0.5f);
    const glm::vec3 normal(std::sin(at), std::cos(at), 0.0f);
    stroke.points.push_back({radius * normal, outward * normal});
  }
  return stroke;
}

TEST(PlacementOnSkin, ArchedSkinKeepsTheHeightAndBuriesTheEnds) {
  for (const float height : {1.8f, 155.0f}) {
    for (const float degrees : {1.0f, 20.0f, 60.0f, 90.0f, 120.0f, 150.0f, 180.0f}) {
      const float radius = 0.08f * height;
      const SkinStroke stroke = arcStroke(radius, glm::radians(degrees), 1.0f);
      const float chord = glm::length(stroke.points.back().point - stroke.points.front().point);
      if (chord < 0.05f * height) continue;
      const glm::mat4 one(1.0f);
      const glm::mat4 shape = shapeInWorld(placementOnSkin(stroke, one, {0, 0, 1}, height), 1.0f, one);
      const glm::mat4 flat = shapeInWorld(
          placementOnSkin(straightStroke({{0, 0, 0}, {0, 1, 0}}, {chord, 0, 0}), one, {0, 0, 1}, height), 1.0f, one);
      EXPECT_GT(std::abs(glm::normalize(glm::vec3(shape[0])).x), 0.9999f);
      const float top = shape[3].y + extentAlong(shape, {0, 1, 0});
      const float flatTop = flat[3].y + extentAlong(flat, {0, 1, 0});
      EXPECT_NEAR(top - radius, flatTop, 1e-3f * height) << degrees;
      for (const float side : {-1.0f, 1.0f}) {
        const glm::vec3 tip = glm::vec3(shape[3]) + side * glm::vec3(shape[0]);
        EXPECT_LT(glm::length(tip), radius + 1e-3f * height) << degrees;
        EXPECT_GT(glm::length(tip), 0.75f * radius) << degrees;
      }
      EXPECT_GT(shape[3].y - extentAlong(shape, {0, 1, 0}), -radius) << "not out of the other side of a limb";
    }
  }
}

TEST(PlacementOnSkin, HollowSkinPutsItOnTheBottom) {
  const float radius = 0.2f;
  const SkinStroke stroke = arcStroke(radius, glm::radians(90.0f), -1.0f);
  const glm::mat4 one(1.0f);
  const glm::mat4 shape = shapeInWorld(placementOnSkin(stroke, one, {0, 0, 1}, 1.8f), 1.0f, one);
  EXPECT_LT(glm::vec3(shape[2]).y, 0.0f) << "out of the skin, into the hollow";
  const float thickness = extentAlong(shape, {0, 1, 0});
  EXPECT_GT(shape[3].y, radius) << "its center is under the skin";
  EXPECT_LT(shape[3].y - thickness, radius - 0.5f * thickness) << "yet it shows";
}

TEST(PlacementOnSkin, ExtremeStrokesGiveValidShapes) {
  const SkinPoint start{glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)};
  const auto at = [](float x, float y, float z) { return SkinPoint{{x, y, z}, {0, 0, 1}}; };
  const std::array<SkinStroke, 6> strokes = {
      SkinStroke{{start}},
      SkinStroke{{start, start, start}},
      SkinStroke{{start, at(0, 1, 3), start}},                            // There and back.
      SkinStroke{{start, at(1, 1, 0), at(50, 1, 0)}},                     // Far away.
      SkinStroke{{start, at(0, 1, 0.5f), at(0, 1, 1)}},                   // Along its own normal.
      SkinStroke{{start, at(0, 1, 1), at(0.1f, 1, 1), at(0.1f, 1, 0)}}};  // Over a spike.
  for (const SkinStroke& stroke : strokes) {
    const Placement placement = placementOnSkin(stroke, glm::mat4(1.0f), glm::vec3(0, 0, 1), 2.0f);
    EXPECT_TRUE(isFinite(placement.center) && isFinite(placement.radii));
    EXPECT_NEAR(glm::length(placement.rotation), 1.0f, 1e-4f);
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(placement.radii[i], 0.01f * 2.0f * 0.999f);
      EXPECT_LE(placement.radii[i], 0.75f * 2.0f * 1.001f);
    }
  }
}

TEST(AddMuscle, DragIsOneStepAndSelectsTheMuscle) {
  LimbScene scene;
  setTool(scene.tools, ToolKind::kAddMuscle);
  const glm::vec2 pixel = scene.skinPixel();
  const RouteResult hover = scene.move(pixel);
  ASSERT_TRUE(scene.tools.hover.skin.has_value());
  const int bone = boneAt(*scene.document.character, *scene.tools.hover.skin);
  const std::string boneName = scene.document.character->skeleton.bones[static_cast<std::size_t>(bone)].name;
  EXPECT_NE(hover.status.find(boneName), std::string::npos);
  scene.press(pixel);
  EXPECT_EQ(scene.document.rig().primitives.size(), 1u) << "there at once";
  for (int i = 1; i < 5; ++i) {
    scene.drag(pixel + static_cast<float>(i) * glm::vec2(2, -15));
    EXPECT_EQ(scene.document.rig().primitives.size(), 1u);
  }
  scene.release(pixel + glm::vec2(8, -60));
  EXPECT_EQ(scene.document.commands.stepCount(), 1u);
  EXPECT_FALSE(scene.document.commands.inGesture());
  EXPECT_EQ(scene.document.rig().primitives[0].name, boneName + " muscle");
  EXPECT_EQ(scene.document.rig().primitives[0].bone, boneName);
  EXPECT_EQ(scene.document.activeName(), boneName + " muscle");
  EXPECT_FALSE(scene.document.rig().primitives[0].group.empty());
  scene.document.commands.undo();
  EXPECT_TRUE(scene.document.rig().primitives.empty());
}

TEST(AddMuscle, WheelChangesTheThicknessDuringTheStroke) {
  LimbScene scene;
  setTool(scene.tools, ToolKind::kAddMuscle);
  const glm::vec2 pixel = scene.skinPixel();
  const glm::vec2 end = pixel + glm::vec2(8, -60);
  scene.move(pixel);
  scene.press(pixel);
  scene.drag(end);
  const CameraStand stand = scene.tools.camera.stand;
  const glm::vec3 plain = scene.document.rig().primitives.at(0).placement.radii;
  ViewportInput turned;
  turned.wheel = 2.0f;
  scene.drag(end, MouseButton::kLeft, turned);
  const glm::vec3 thick = scene.document.rig().primitives.at(0).placement.radii;
  EXPECT_EQ(thick.x, plain.x) << "as long as drawn";
  EXPECT_GT(thick.y, 1.1f * plain.y);
  EXPECT_GT(thick.z, 1.1f * plain.z);
  scene.drag(end + glm::vec2(0, -10));
  EXPECT_GT(scene.document.rig().primitives.at(0).placement.radii.z, thick.z) << "kept while the stroke goes on";
  turned.wheel = -4.0f;
  scene.drag(end, MouseButton::kLeft, turned);
  EXPECT_LT(scene.document.rig().primitives.at(0).placement.radii.z, plain.z);
  EXPECT_TRUE(test::sameStand(scene.tools.camera.stand, stand)) << "it does not zoom meanwhile";
  scene.release(end);
  EXPECT_EQ(scene.document.commands.stepCount(), 1u);
}

TEST(AddMuscle, SecondMuscleGetsAFreeName) {
  LimbScene scene;
  setTool(scene.tools, ToolKind::kAddMuscle);
  scene.click(scene.skinPixel());
  scene.click(scene.skinPixel() + glm::vec2(0, 3));
  ASSERT_EQ(scene.document.rig().primitives.size(), 2u);
  EXPECT_EQ(scene.document.rig().primitives[1].name, scene.document.rig().primitives[0].name + " 2");
}

TEST(AddMuscle, EscapeAndTheRightButtonLeaveNoTrace) {
  ViewportInput escape;
  escape.keysPressed = {Key::kEscape};
  ViewportInput right;
  right.buttons[1].pressed = true;
  for (const ViewportInput& leave : {escape, right}) {
    LimbScene scene;
    scene.document.selection.bone = 1;
    setTool(scene.tools, ToolKind::kAddMuscle);
    const CameraStand before = scene.tools.camera.stand;
    const glm::vec2 pixel = scene.skinPixel();
    scene.move(pixel);
    scene.press(pixel);
    scene.drag(pixel + glm::vec2(0, 40));
    scene.drag(pixel + glm::vec2(0, 50), MouseButton::kLeft, leave);
    EXPECT_TRUE(scene.document.rig().primitives.empty());
    EXPECT_EQ(scene.document.commands.stepCount(), 0u);
    EXPECT_TRUE(scene.document.selection.primitives.empty());
    EXPECT_EQ(scene.document.selection.bone, 1);
    scene.drag(pixel + glm::vec2(0, 90));
    scene.release(pixel + glm::vec2(0, 90));
    EXPECT_TRUE(test::sameStand(before, scene.tools.camera.stand));
  }
}

TEST(AddMuscle, WorksOnAFoxWithScaledBones) {
  const auto fox = test::realCharacter("Fox.glb");
  if (!fox) GTEST_SKIP() << "left out: real characters are not at hand";
  LimbScene scene(fox);
  setTool(scene.tools, ToolKind::kAddMuscle);
  scene.tools.camera.stand.yaw = 1.5f;
  Random random(53);
  int added = 0;
  for (int i = 0; i < 40; ++i) {
    const glm::vec2 pixel(random.uniform(200, 800), random.uniform(200, 600));
    scene.move(pixel);
    if (!scene.tools.hover.skin) continue;
    const glm::vec3 hit = scene.tools.hover.pointInWorld;
    const int bone = boneAt(*fox, *scene.tools.hover.skin);
    scene.press(pixel);
    scene.drag(pixel + glm::vec2(25, 0));
    scene.release(pixel + glm::vec2(25, 0));
    ASSERT_EQ(static_cast<int>(scene.document.rig().primitives.size()), ++added);
    const Primitive& muscle = scene.document.rig().primitives.back();
    EXPECT_EQ(muscle.bone, fox->skeleton.fileName(bone));
    const glm::mat4& boneInWorld = scene.pose.boneInWorld[static_cast<std::size_t>(bone)];
    const glm::vec3 center(boneInWorld * glm::vec4(muscle.placement.center, 1.0f));
    EXPECT_LT(glm::length(center - hit), 0.8f * fox->height);
  }
  EXPECT_GT(added, 3);
}

}  // namespace
}  // namespace sinew::app
