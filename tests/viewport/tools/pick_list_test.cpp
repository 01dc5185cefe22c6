// tests/viewport/tools/pick_list_test.cpp: the first pick is the visible object; checked by a slow search along each
// ray.
#include "app/viewport/tools/select.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/characters/real_characters.h"
#include "tests/viewport/tools/laid_muscles.h"

namespace sinew::app {
namespace {

using test::LimbScene;

// The oracle -------------------------------------------------------------------------------------------------------

struct Crossing {
  double distance;
  bool front;
};

/// Moeller & Trumbore against every triangle, in doubles.
std::vector<Crossing> bruteForce(const Ray& ray, const Surface& surface) {
  std::vector<Crossing> all;
  const glm::dvec3 origin(ray.origin), direction(ray.direction);
  for (const auto& corners : surface.refinement->triangles) {
    const auto at = [&](std::size_t i) { return glm::dvec3(surface.positions[static_cast<std::size_t>(corners[i])]); };
    const glm::dvec3 a = at(0), e1 = at(1) - a, e2 = at(2) - a;
    const glm::dvec3 p = glm::cross(direction, e2);
    const double det = glm::dot(e1, p);
    if (std::abs(det) < 1e-18) continue;
    const glm::dvec3 s = origin - a;
    const double u = glm::dot(s, p) / det;
    const glm::dvec3 q = glm::cross(s, e1);
    const double v = glm::dot(direction, q) / det;
    const double t = glm::dot(e2, q) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && t > 0) all.push_back({t, glm::dot(glm::cross(e1, e2), direction) < 0});
  }
  std::ranges::sort(all, {}, &Crossing::distance);
  return all;
}

/// A muscle in the world, sampled in steps.
struct Shell {
  glm::dmat3 toBall;
  glm::dvec3 center;
  double thickness;  ///< Along the ray.

  Shell(const Primitive& primitive, const glm::mat4& boneInWorld, const Ray& ray) {
    const glm::dmat4 shape(shapeInWorld(primitive.placement, 1.0f, boneInWorld));
    toBall = glm::inverse(glm::dmat3(shape));
    center = glm::dvec3(shape[3]);
    // The widest chord along the ray goes through the center.
    thickness = 2.0 / glm::length(toBall * glm::dvec3(ray.direction));
  }
  [[nodiscard]] double radii(const Ray& ray, double t) const {
    return glm::length(toBall * (glm::dvec3(ray.origin) + t * glm::dvec3(ray.direction) - center));
  }
};

const Primitive& muscleOf(const LimbScene& scene, const PickEntry& entry) {
  return scene.document.rig().primitives[static_cast<std::size_t>(findPrimitive(scene.document.rig(), entry.muscle))];
}

Shell shellOf(const LimbScene& scene, const PickEntry& entry, const Ray& ray) {
  const Primitive& muscle = muscleOf(scene, entry);
  const int bone = *scene.document.character->skeleton.findBone(muscle.bone);
  return {muscle, scene.pose.boneInWorld[static_cast<std::size_t>(bone)], ray};
}

/// Distance of the first visible skin; infinite if none.
double seenSkin(const std::vector<Crossing>& crossings) {
  for (const Crossing& crossing : crossings) {
    if (crossing.front) return crossing.distance;
  }
  return std::numeric_limits<double>::infinity();
}

/// Some of the muscle, or slightly more than its shell, lies within its own thickness behind the first skin, and the
/// ray does not leave the body before reaching it.
void expectSeen(const LimbScene& scene, const Ray& ray, const PickEntry& entry) {
  const double height = scene.document.character->height;
  const std::vector<Crossing> crossings = bruteForce(ray, scene.surface);
  const Shell shell = shellOf(scene, entry, ray);
  const double skin = seenSkin(crossings);
  const double reach = 1.45;  // Radii: bulges reach beyond the shell.
  const double step = 0.001 * height;
  double enter = std::numeric_limits<double>::infinity();
  const double end = glm::distance(glm::dvec3(ray.origin), shell.center) + 2.0 * height;
  for (double t = 0.0; t < end && std::isinf(enter); t += step) {
    if (shell.radii(ray, t) <= reach) enter = t;
  }
  ASSERT_FALSE(std::isinf(enter)) << muscleOf(scene, entry).name << " is nowhere near the ray";
  EXPECT_LE(enter, skin + shell.thickness + 2.0 * step) << muscleOf(scene, entry).name << " lies too deep";
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const bool air = !crossings[i - 1].front && crossings[i].front &&
                     crossings[i].distance - crossings[i - 1].distance > 0.01 * height;
    const bool between = crossings[i - 1].distance > skin && crossings[i].distance < enter - 2.0 * step;
    EXPECT_FALSE(air && between) << muscleOf(scene, entry).name << " lies behind another part of the body";
  }
}

/// Views a scene from random directions, at pixels on and beside the body.
void lookFromEverywhere(LimbScene& scene, int views, int pixels) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  int muscles = 0;
  for (int i = 0; i < views; ++i) {
    scene.display.primitives = i % 2 == 0;
    scene.tools.camera.orthographic = i % 3 == 0;
    scene.tools.camera.stand.yaw = 6.2831853f * unit(random);
    scene.tools.camera.stand.pitch = 1.6f * (unit(random) - 0.5f);
    frameBounds(scene.tools.camera, boundsOf(scene.surface.positions), LimbScene::kSize, false);
    const View view = viewOf(scene.tools.camera, LimbScene::kSize);
    for (int j = 0; j < pixels; ++j) {
      const auto& points = scene.surface.positions;
      const auto at = static_cast<std::size_t>(unit(random) * static_cast<float>(points.size() - 1));
      const glm::vec2 off = 8.0f * glm::vec2(unit(random) - 0.5f, unit(random) - 0.5f);
      const glm::vec2 pixel = glm::vec2(view.toPixel(points[at])) + off;
      const ViewportHover hover = hoverAt(scene.context(), view, pixel);
      if (hover.primitive < 0) continue;
      ++muscles;
      ASSERT_FALSE(hover.here.empty());
      expectSeen(scene, view.rayThrough(pixel), hover.here.front());
      if (testing::Test::HasFailure()) {
        FAIL() << "view " << i << ", pixel " << pixel.x << ' ' << pixel.y;
      }
    }
  }
  EXPECT_GE(muscles, views * pixels / 40) << "too little was picked to say anything";
}

/// A scene with muscles as the tool lays them. None if nothing could be laid.
std::optional<LimbScene> laid(const std::shared_ptr<const Character>& character, int count) {
  LimbScene scene(character);
  Rig rig = test::layMuscles(character, count);
  if (rig.primitives.empty()) return std::nullopt;
  rig.smoothing.depth = 2;
  scene.document.commands.apply("Lay", rig);
  scene.smooth();
  return scene;
}

TEST(PickList, FirstPickIsNeverBehindASyntheticBody) {
  for (const auto& character : {test::makeTwoLegged(), test::makeLimb()}) {
    std::optional<LimbScene> scene = laid(character, 8);
    ASSERT_TRUE(scene);
    lookFromEverywhere(*scene, 12, 60);
  }
}

TEST(PickList, FirstPickIsNeverBehindARealBody) {
  int found = 0;
  for (const char* file : {"Fox.glb", "cesium_man.gltf", "greenman.glb", "robot.glb"}) {
    const auto character = test::realCharacter(file);
    if (!character) continue;
    ++found;
    SCOPED_TRACE(file);
    std::optional<LimbScene> scene = laid(character, 10);
    ASSERT_TRUE(scene);
    lookFromEverywhere(*scene, 8, 40);
  }
  if (found == 0) GTEST_SKIP() << "left out: no real characters at hand";
}

/// Seen along its own normal, a click picks the laid muscle; from the other side it does not.
void expectFromItsSide(const std::shared_ptr<const Character>& character) {
  std::optional<LimbScene> scene = laid(character, 8);
  ASSERT_TRUE(scene);
  int own = 0, through = 0, all = 0;
  for (std::size_t i = 0; i < scene->document.rig().primitives.size(); ++i) {
    const Primitive& muscle = scene->document.rig().primitives[i];
    const auto bone = static_cast<std::size_t>(*scene->document.character->skeleton.findBone(muscle.bone));
    const glm::mat4 shape = shapeInWorld(muscle.placement, 1.0f, scene->pose.boneInWorld[bone]);
    const glm::vec3 out = glm::normalize(glm::vec3(shape[2]));  // +z points out of the skin.
    for (const float side : {1.0f, -1.0f}) {
      const Ray ray{glm::vec3(shape[3]) + side * 3.0f * character->height * out, -side * out};
      const auto crossings = bruteForce(ray, scene->surface);
      // Beyond it the body is at least as thick as the muscle.
      const double depth = glm::dot(glm::dvec3(shape[3]) - glm::dvec3(ray.origin), glm::dvec3(ray.direction));
      const bool behindBody = depth - seenSkin(crossings) > 1.6 * glm::length(glm::vec3(shape[2]));
      if (side < 0.0f && !behindBody) continue;
      scene->display.primitives = true;
      const auto skin = pickSurface(ray, scene->surface, character->mesh, character->materials);
      ASSERT_TRUE(skin);
      const int skinBone = [&] {
        SkinAnchor anchor{skin->controlTriangle, skin->controlBarycentric, 0.0f};
        return boneAt(*character, anchor);
      }();
      const auto here = musclesUnder(scene->context(), ray, skin, skinBone);
      const bool taken = !here.empty() && !here.front().concealed && here.front().muscle == muscle.id();
      const bool listed = std::ranges::any_of(here, [&](const PickEntry& e) { return e.muscle == muscle.id(); });
      EXPECT_TRUE(listed) << muscle.name;
      all += side > 0.0f ? 1 : 0;
      own += side > 0.0f && taken ? 1 : 0;
      through += side < 0.0f && taken ? 1 : 0;
    }
  }
  EXPECT_GE(own, (3 * all + 3) / 4) << "of " << all;  // Others may lie over it.
  EXPECT_EQ(through, 0);
}

TEST(PickList, MuscleIsPickedOnlyFromItsOwnSide) {
  expectFromItsSide(test::makeTwoLegged());
  for (const char* file : {"Fox.glb", "cesium_man.gltf", "greenman.glb"}) {
    const auto character = test::realCharacter(file);
    if (!character) continue;
    SCOPED_TRACE(file);
    expectFromItsSide(character);
  }
}

// Synthetic scenes -------------------------------------------------------------------------------------------------

/// A torso with one muscle in front and one behind, both just under the skin; seen from the front.
struct FrontAndBack : LimbScene {
  FrontAndBack() : LimbScene(test::makeTwoLegged()) {
    const int spine = *document.character->skeleton.findBone("spine");
    const glm::mat4& boneInWorld = pose.boneInWorld[static_cast<std::size_t>(spine)];
    const glm::vec3 middle(
        boneInWorld * glm::vec4(0.5f * document.character->skeleton.bones[static_cast<std::size_t>(spine)].tip, 1.0f));
    const Ray ahead{middle + glm::vec3(0, 0, 10), {0, 0, -1}};
    const auto crossings = bruteForce(ahead, surface);
    EXPECT_GE(crossings.size(), 2u);
    front = middle + glm::vec3(0, 0, 10.0f - static_cast<float>(crossings.front().distance));
    back = middle + glm::vec3(0, 0, 10.0f - static_cast<float>(crossings.back().distance));
    depth = front.z - back.z;
    Rig rig;
    for (const bool chest : {true, false}) {
      Primitive muscle;
      muscle.name = chest ? "chest" : "back";
      muscle.bone = "spine";
      const glm::vec3 radii = glm::vec3(0.20f, 0.25f, 0.10f) * depth;
      const glm::vec3 at = chest ? front - glm::vec3(0, 0, 0.09f * depth) : back + glm::vec3(0, 0, 0.09f * depth);
      muscle.placement = {glm::vec3(glm::inverse(boneInWorld) * glm::vec4(at, 1.0f)), {1, 0, 0, 0}, radii};
      rig = addPrimitive(rig, muscle).value();
    }
    document.commands.apply("Set up", rig);
    smooth();
    setTool(tools, ToolKind::kSelect);
    look(0.0f);
  }
  void look(float yaw) {
    tools.camera.stand.yaw = yaw;
    tools.camera.stand.pitch = 0.0f;
    pixel = glm::vec2(viewOf(tools.camera, kSize).toPixel(0.5f * (front + back)));
  }
  [[nodiscard]] std::string active() const { return document.activeName(); }

  glm::vec3 front{0.0f}, back{0.0f};
  float depth = 0.0f;
  glm::vec2 pixel{0.0f};
};

TEST(PickList, ChestAndBackArePickedFromTheirSides) {
  for (const bool shells : {true, false}) {
    for (const float yaw : {0.0f, 3.14159f}) {
      FrontAndBack scene;
      scene.display.primitives = shells;
      scene.look(yaw);
      scene.click(scene.pixel);
      EXPECT_EQ(scene.active(), yaw == 0.0f ? "chest" : "back") << shells;
    }
  }
}

TEST(PickList, NothingIsPickedThroughBareSkin) {
  FrontAndBack scene;
  scene.display.primitives = true;
  Rig rig = scene.document.rig();
  rig.primitives.erase(rig.primitives.begin());
  scene.document.commands.apply("Delete", rig);
  scene.smooth();
  scene.click(scene.pixel);
  EXPECT_EQ(scene.active(), "");
  EXPECT_GE(scene.document.selection.bone, 0);
}

TEST(PickList, LockedMusclesAreNotListed) {
  FrontAndBack scene;
  scene.display.primitives = true;
  EXPECT_EQ(hoverAt(scene.context(), viewOf(scene.tools.camera, LimbScene::kSize), scene.pixel).here.size(), 2u);
  scene.document.visibility.setMuscle(Mark::kLocked, scene.document.idAt(0), true);
  const ViewportHover hover = hoverAt(scene.context(), viewOf(scene.tools.camera, LimbScene::kSize), scene.pixel);
  ASSERT_EQ(hover.here.size(), 2u);
  EXPECT_FALSE(hover.here[0].muscle) << "the skin stands for its bone";
  EXPECT_TRUE(hover.here[1].concealed);
}

TEST(BodySpan, JoinsLayersButNotAirGaps) {
  const auto leave = [](std::vector<SurfaceCrossing> crossings) { return bodySpan(crossings, 1.0f, 0.1f).leave; };
  EXPECT_EQ(leave({{1, true}, {3, false}}), 3.0f);
  EXPECT_EQ(leave({{1, true}, {1.05f, false}, {1.1f, true}, {3, false}}), 3.0f) << "a shirt";
  EXPECT_EQ(leave({{1, true}, {1.05f, true}, {3, false}, {3.05f, false}}), 3.0f) << "an open shirt";
  EXPECT_EQ(leave({{1, true}, {1.5f, false}, {2, true}, {3, false}}), 1.5f) << "a hand before the belly";
  EXPECT_EQ(leave({{1, true}, {2, true}, {2.5f, false}, {3, false}}), 2.0f) << "an arm that dips into the belly";
  EXPECT_TRUE(std::isinf(leave({{1, true}}))) << "an open sheet";
}

}  // namespace
}  // namespace sinew::app
