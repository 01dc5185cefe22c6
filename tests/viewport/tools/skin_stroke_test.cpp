// tests/viewport/tools/skin_stroke_test.cpp: a stroke stays on the skin on which it began, and its muscle follows it.

#include "app/viewport/tools/add_muscle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/document/playback.h"
#include "app/viewport/render/picking.h"
#include "tests/viewport/tools/limb_scene.h"

namespace sinew::app {
namespace {

using test::LimbScene;
using test::Random;

struct StrokeScene : LimbScene {
  using LimbScene::LimbScene;

  [[nodiscard]] View view() const { return viewOf(tools.camera, kSize); }
  [[nodiscard]] std::optional<SurfaceHit> hit(const glm::vec2& pixel) const {
    const Character& character = *document.character;
    return pickSurface(view().rayThrough(pixel), surface, character.mesh, character.materials);
  }
  [[nodiscard]] SkinStroke stroke(const glm::vec2& from, const glm::vec2& to) const {
    const std::optional<SurfaceHit> start = hit(from);
    EXPECT_TRUE(start.has_value());
    return strokeOnSkin(snapshotOf(surface), {start->position, start->normal}, view(), to, document.character->height);
  }
  /// Presses, drags in steps and releases with the add-muscle tool; the surface follows every step, as in the editor.
  Placement drawn(const glm::vec2& from, const glm::vec2& to) {
    setTool(tools, ToolKind::kAddMuscle);
    move(from);
    press(from);
    for (int i = 1; i <= 8; ++i) {
      smooth();
      drag(glm::mix(from, to, static_cast<float>(i) / 8.0f));
    }
    release(to);
    EXPECT_FALSE(document.rig().primitives.empty());
    return document.rig().primitives.empty() ? Placement{} : document.rig().primitives.back().placement;
  }
};

/// Pixels on the visible body and beyond it.
glm::vec2 randomPixel(Random& random) { return {random.uniform(250, 750), random.uniform(50, 750)}; }

TEST(SkinStroke, FollowsTheSkinUnderThePointerLine) {
  Random random(61);
  int reached = 0, compared = 0;
  for (int i = 0; i < 200; ++i) {
    StrokeScene scene(i % 2 ? test::makeLimb() : test::makeTube());
    scene.tools.camera.stand.yaw = random.uniform(-3.0f, 3.0f);
    scene.tools.camera.stand.pitch = random.uniform(-1.0f, 1.0f);
    scene.tools.camera.orthographic = random.chance(0.3f);
    const float height = scene.document.character->height;
    const glm::vec2 from = randomPixel(random), to = randomPixel(random);
    if (!scene.hit(from)) continue;
    const SkinStroke stroke = scene.stroke(from, to);
    const glm::vec2 direction = glm::normalize(to - from);
    float last = -0.01f;
    for (const SkinPoint& at : stroke.points) {
      const glm::vec2 offset = glm::vec2(scene.view().toPixel(at.point)) - from;
      EXPECT_LT(std::abs(offset.x * direction.y - offset.y * direction.x), 0.5f) << "on the line";
      EXPECT_GE(glm::dot(offset, direction), last) << "onwards";
      last = glm::dot(offset, direction) - 0.01f;
      const glm::vec3 sight = scene.view().rayThrough(from + offset).direction;
      if (glm::dot(at.normal, sight) > -0.3f) continue;  // Near the outline half a pixel is a long distance.
      const std::optional<SurfaceHit> seen = scene.hit(from + offset);
      if (!seen) continue;  // The outline is a sharp edge.
      EXPECT_LT(glm::length(seen->position - at.point), 2e-3f * height) << "what is seen there";
      ++compared;
    }
    const std::optional<SurfaceHit> end = scene.hit(to);
    if (!end) continue;
    EXPECT_LT(glm::length(end->position - stroke.points.back().point), 1e-3f * height) << "convex: up to the pointer";
    ++reached;
  }
  EXPECT_GT(reached, 20);
  EXPECT_GT(compared, 500);
}

TEST(SkinStroke, EndsOnTheSkinBeyondTheOutline) {
  StrokeScene scene;
  const glm::vec2 from = scene.skinPixel();
  for (const glm::vec2 to : {glm::vec2(5000, from.y), glm::vec2(-900, -700), glm::vec2(from.x, 1e5f)}) {
    const SkinStroke stroke = scene.stroke(from, to);
    const SkinPoint& end = stroke.points.back();
    const glm::vec2 pixel(scene.view().toPixel(end.point));
    const glm::vec2 direction = glm::normalize(to - from);
    EXPECT_TRUE(scene.hit(pixel - 2.0f * direction)) << "seen just before";
    EXPECT_FALSE(scene.hit(pixel + 2.0f * direction)) << "and nothing after";
    EXPECT_LT(std::abs(glm::dot(end.normal, glm::normalize(end.point - scene.view().eyeInWorld))), 0.4f)
        << "where the skin turns away";
  }
}

/// A sheet in the XY plane, 2 long in X, that drops behind an overhanging edge at x = 1 and goes on at z = -depth.
SkinSnapshot sheetWithFold(float depth) {
  const std::array<glm::vec2, 4> profile{{{0.0f, 0.0f}, {1.0f, 0.0f}, {0.99f, -depth}, {2.0f, -depth}}};
  auto refinement = std::make_shared<Refinement>();
  SkinSnapshot skin;
  for (const glm::vec2& at : profile) {
    for (const float y : {-0.5f, 0.5f}) skin.positions.emplace_back(at.x, y, at.y);
  }
  for (int i = 0; i < 6; i += 2) {
    refinement->triangles.push_back({i, i + 2, i + 3});
    refinement->triangles.push_back({i, i + 3, i + 1});
  }
  skin.normals.assign(skin.positions.size(), glm::vec3(0, 0, 1));
  skin.refinement = refinement;
  return skin;
}

TEST(SkinStroke, CrossesSmallFoldsButNotLargeOnes) {
  Camera camera;
  camera.characterHeight = 2.0f;
  camera.scene = {{0, -1, -1}, {2, 1, 1}};
  camera.orthographic = true;
  camera.stand.target = {1, 0, 0};
  camera.stand.distance = 5.0f;
  camera.stand.yaw = camera.stand.pitch = 0.0f;
  const View view = viewOf(camera, {1000, 800});
  const glm::vec2 to(view.toPixel({1.8f, 0.1f, 0.0f}));
  const SkinPoint start{{0.2f, 0.1f, 0.0f}, {0, 0, 1}};
  EXPECT_NEAR(strokeOnSkin(sheetWithFold(0.01f), start, view, to, 2.0f).points.back().point.x, 1.8f, 1e-3f);
  EXPECT_NEAR(strokeOnSkin(sheetWithFold(0.5f), start, view, to, 2.0f).points.back().point.x, 1.0f, 1e-3f);
}

TEST(SkinStroke, StaysOnItsLeg) {
  StrokeScene scene(test::makeTwoLegged());
  const Skeleton& skeleton = scene.document.character->skeleton;
  const auto middleOf = [&](const char* bone) {
    const auto index = static_cast<std::size_t>(*skeleton.findBone(bone));
    return glm::vec3(scene.pose.boneInWorld[index] * glm::vec4(0.5f * skeleton.bones[index].tip, 1.0f));
  };
  const glm::vec2 left(scene.view().toPixel(middleOf("shin L")));
  const glm::vec2 right(scene.view().toPixel(middleOf("shin R")));
  ASSERT_TRUE(scene.hit(left) && scene.hit(right));
  for (const SkinPoint& at : scene.stroke(left, right).points) EXPECT_GT(at.point.x, 0.0f);
  for (const SkinPoint& at : scene.stroke(right, left).points) EXPECT_LT(at.point.x, 0.0f);

  scene.document.symmetry = false;
  scene.drawn(left, right);
  const Primitive& muscle = scene.document.rig().primitives[0];
  EXPECT_EQ(muscle.bone, "shin L");
  const glm::mat4 shape = shapeInWorld(muscle.placement, 1.0f,
                                       scene.pose.boneInWorld[static_cast<std::size_t>(*skeleton.findBone("shin L"))]);
  for (const float side : {-1.0f, 1.0f}) EXPECT_GT(shape[3].x + side * shape[0].x, 0.0f);
}

TEST(SkinStroke, MuscleAroundABodyEndsAtTheSkin) {
  Random random(62);
  int drawn = 0;
  for (int i = 0; i < 120; ++i) {
    StrokeScene scene(i % 2 ? test::makeLimb() : test::makeTube());
    scene.tools.camera.stand.yaw = random.uniform(-3.0f, 3.0f);
    const glm::vec2 from = randomPixel(random), to = randomPixel(random);
    if (!scene.hit(from)) continue;
    const float height = scene.document.character->height;
    const SkinStroke stroke = scene.stroke(from, to);
    const glm::vec3 chord = stroke.points.back().point - stroke.points.front().point;
    const Surface bare = scene.surface;
    if (glm::length(chord) < 0.05f * height) continue;
    scene.drawn(from, to);
    const Primitive& muscle = scene.document.rig().primitives[0];
    const Skeleton& skeleton = scene.document.character->skeleton;
    const glm::mat4 shape = shapeInWorld(
        muscle.placement, 1.0f, scene.pose.boneInWorld[static_cast<std::size_t>(*skeleton.findBone(muscle.bone))]);
    EXPECT_GT(std::abs(glm::dot(glm::normalize(glm::vec3(shape[0])), glm::normalize(chord))), 0.999f) << "on the chord";
    for (const float side : {-1.0f, 1.0f}) {
      const glm::vec3 tip = glm::vec3(shape[3]) + side * glm::vec3(shape[0]);
      std::size_t nearest = 0;
      for (std::size_t v = 1; v < bare.positions.size(); ++v) {
        if (glm::length(bare.positions[v] - tip) < glm::length(bare.positions[nearest] - tip)) nearest = v;
      }
      const float above = glm::dot(tip - bare.positions[nearest], bare.normals[nearest]);
      // By the muscle's thickness: on a curved body, the ends of the straight chord are level with its top.
      EXPECT_LT(above, 0.012f * height) << i << ": a tip stands out of the skin";
      EXPECT_LT(glm::length(tip - bare.positions[nearest]), 0.3f * glm::length(glm::vec3(shape[0])) + 0.03f * height)
          << i << ": a tip is far from the skin";
    }
    ++drawn;
  }
  EXPECT_GT(drawn, 20);
}

TEST(SkinStroke, IgnoresTheSwellingOfTheNewMuscle) {
  StrokeScene scene;
  const glm::vec2 from = scene.skinPixel(), to = from + glm::vec2(30, -120);
  setTool(scene.tools, ToolKind::kAddMuscle);
  scene.move(from);
  scene.press(from);
  scene.drag(to);
  const Placement first = scene.document.rig().primitives[0].placement;
  for (int i = 0; i < 5; ++i) {
    scene.smooth();
    scene.drag(to);
  }
  const Placement& last = scene.document.rig().primitives[0].placement;
  EXPECT_EQ(first.center, last.center);
  EXPECT_EQ(first.radii, last.radii);
}

/// A stroke that takes a second, with the editor's frames in order.
Placement drawnInASecond(bool playing) {
  StrokeScene scene;
  const Character& character = *scene.document.character;
  Transport transport;
  chooseClip(transport, 0, character);
  transport.time = 0.4;
  transport.playing = playing;
  setTool(scene.tools, ToolKind::kAddMuscle);
  const auto frame = [&](bool leftPressed) {
    if (!holdsPose(scene.tools, leftPressed)) advance(transport, 1.0 / 60.0, character);
    scene.pose = poseAt(transport, character);
  };
  scene.pose = poseAt(transport, character);
  scene.smooth();
  const glm::vec2 from = scene.skinPixel();
  frame(true);
  scene.press(from);
  for (int i = 1; i <= 60; ++i) {
    scene.smooth();
    frame(false);
    scene.drag(from + static_cast<float>(i) * glm::vec2(0.4f, -2.0f));
  }
  frame(false);
  EXPECT_EQ(transport.time, 0.4) << "held while the button is down";
  EXPECT_EQ(transport.playing, playing);
  scene.release(from + 60.0f * glm::vec2(0.4f, -2.0f));
  frame(false);
  EXPECT_EQ(transport.time > 0.4, playing) << "and goes on after it";
  return scene.document.rig().primitives.at(0).placement;
}

TEST(SkinStroke, DoesNotDependOnPlayback) {
  const Placement still = drawnInASecond(false);
  const Placement moving = drawnInASecond(true);
  EXPECT_EQ(still.center, moving.center);
  EXPECT_EQ(still.radii, moving.radii);
  EXPECT_EQ(still.rotation, moving.rotation);
}

TEST(SkinStroke, OnlyDrawingHoldsThePose) {
  LimbScene scene;
  EXPECT_FALSE(holdsPose(scene.tools, true)) << "another tool's press";
  setTool(scene.tools, ToolKind::kAddMuscle);
  EXPECT_FALSE(holdsPose(scene.tools, false));
  EXPECT_TRUE(holdsPose(scene.tools, true));
  scene.move(scene.skinPixel());
  scene.press(scene.skinPixel());
  EXPECT_TRUE(holdsPose(scene.tools, false));
  ViewportInput escape;
  escape.keysPressed = {Key::kEscape};
  scene.drag(scene.skinPixel(), MouseButton::kLeft, escape);
  EXPECT_FALSE(holdsPose(scene.tools, false));
}

}  // namespace
}  // namespace sinew::app
