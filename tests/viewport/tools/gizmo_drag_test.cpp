// tests/viewport/tools/gizmo_drag_test.cpp: a grabbed handle follows the pointer, on every bone, under every camera.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/viewport/tools/gizmo.h"
#include "tests/viewport/tools/random_gizmo.h"

namespace sinew::app {
namespace {

using test::BoneScale;
using test::GizmoScene;
using test::pixelOf;
using test::pointerAt;
using test::Random;
using test::releasedAt;

constexpr float kHalfTurn = std::numbers::pi_v<float>;

GizmoHandle handle(GizmoHandle first, int by) { return static_cast<GizmoHandle>(static_cast<int>(first) + by); }

glm::vec3 worldShift(const GizmoScene& scene, const Placement& after) {
  return glm::mat3(scene.context.boneInWorld) * (after.center - scene.placement.center);
}

/// Length of an arm in the world.
float armOf(const GizmoScene& scene) {
  return 95.0f * scene.context.uiScale * scene.context.view.unitsPerPixelAt(scene.originInWorld());
}

glm::vec3 hitPlane(const Ray& ray, const glm::vec3& origin, const glm::vec3& normal) {
  return ray.origin + (glm::dot(normal, origin - ray.origin) / glm::dot(normal, ray.direction)) * ray.direction;
}

class GizmoDragOnBones : public ::testing::TestWithParam<BoneScale> {};
INSTANTIATE_TEST_SUITE_P(Scales, GizmoDragOnBones,
                         ::testing::Values(BoneScale::kEven, BoneScale::kMirrored, BoneScale::kUneven));

TEST_P(GizmoDragOnBones, DragWithoutMotionChangesNothing) {
  Random random(31);
  for (int i = 0; i < 60; ++i) {
    const GizmoScene scene = test::randomGizmo(random, GetParam());
    for (int h = 1; h < kGizmoHandleCount; ++h) {
      GizmoState state;
      beginDrag(state, static_cast<GizmoHandle>(h), scene.placement, {500, 400}, scene.context);
      const DragResult result = updateDrag(state, releasedAt({500, 400}), scene.context);
      EXPECT_EQ(result.outcome, DragOutcome::kCommitted);
      EXPECT_EQ(result.placement.center, scene.placement.center);
      EXPECT_EQ(result.placement.rotation, scene.placement.rotation);
      EXPECT_EQ(result.placement.radii, scene.placement.radii);
      EXPECT_FALSE(state.drag.has_value());
    }
  }
}

TEST_P(GizmoDragOnBones, ArrowsMoveTheGrabbedPointAlongTheirAxis) {
  Random random(32);
  int tried = 0;
  for (int i = 0; i < 300; ++i) {
    const GizmoScene scene = test::randomGizmo(random, GetParam());
    GizmoState state;
    state.axes = static_cast<GizmoAxes>(random.below(3));
    const int axis = random.below(3);
    if (!layoutGizmo(state, scene.placement, scene.context).find(handle(GizmoHandle::kMoveX, axis))) continue;
    const auto axes = gizmoAxes(state.axes, scene.placement, scene.context.boneInWorld);
    const glm::vec3 direction = axes[static_cast<std::size_t>(axis)];
    const float arm = armOf(scene);
    const float from = 0.8f * arm;
    const float to = random.uniform(-1.5f, 1.5f) * arm;
    const glm::vec3 origin = scene.originInWorld();
    const auto onAxis = [&](float t) { return pixelOf(scene.context.view, origin + t * direction); };
    beginDrag(state, handle(GizmoHandle::kMoveX, axis), scene.placement, onAxis(from), scene.context);
    // In two steps, as with a mouse.
    static_cast<void>(updateDrag(state, pointerAt(onAxis(0.5f * (from + to))), scene.context));
    const DragResult result = updateDrag(state, releasedAt(onAxis(to)), scene.context);
    EXPECT_LT(glm::length(worldShift(scene, result.placement) - (to - from) * direction), 0.01f * arm) << i;
    ++tried;
  }
  EXPECT_GT(tried, 150);
}

TEST_P(GizmoDragOnBones, PlanesAndCenterKeepTheGrabbedPointUnderThePointer) {
  Random random(33);
  int tried = 0;
  for (int i = 0; i < 300; ++i) {
    const GizmoScene scene = test::randomGizmo(random, GetParam());
    GizmoState state;
    state.axes = static_cast<GizmoAxes>(random.below(3));
    const int plane = random.below(4);  // xy, yz, zx, screen.
    const GizmoHandle which = handle(GizmoHandle::kMoveXY, plane);
    const GizmoLayout layout = layoutGizmo(state, scene.placement, scene.context);
    const HandleShape* shape = layout.find(which);
    if (!shape) continue;
    const auto axes = gizmoAxes(state.axes, scene.placement, scene.context.boneInWorld);
    glm::vec3 normal = scene.context.view.forwardInWorld();
    if (plane < 3) {
      const auto first = static_cast<std::size_t>(plane);
      normal = glm::normalize(glm::cross(axes[first], axes[(first + 1) % 3]));
    }
    const glm::vec2 target = shape->anchor + glm::vec2(random.uniform(-40, 40), random.uniform(-40, 40));
    const Ray ray = scene.context.view.rayThrough(target);
    const glm::vec3 grabbed = hitPlane(scene.context.view.rayThrough(shape->anchor), scene.originInWorld(), normal);
    const glm::vec3 wanted = hitPlane(ray, scene.originInWorld(), normal);
    const bool behind = glm::dot(wanted - ray.origin, ray.direction) < 0.0f;
    if (behind || glm::length(wanted - grabbed) > 3.0f * armOf(scene)) continue;
    beginDrag(state, which, scene.placement, shape->anchor, scene.context);
    const DragResult result = updateDrag(state, releasedAt(target), scene.context);
    const glm::vec3 now = grabbed + worldShift(scene, result.placement);
    EXPECT_LT(glm::length(pixelOf(scene.context.view, now) - target), 0.3f) << i << " " << nameOf(which);
    EXPECT_LT(std::abs(glm::dot(now - grabbed, normal)), 2e-3f * armOf(scene));
    EXPECT_EQ(result.placement.radii, scene.placement.radii);
    ++tried;
  }
  EXPECT_GT(tried, 100);
}

TEST_P(GizmoDragOnBones, TypedLengthIsTheWorldShift) {
  Random random(34);
  for (int i = 0; i < 200; ++i) {
    const GizmoScene scene = test::randomGizmo(random, GetParam());
    GizmoState state;
    state.axes = static_cast<GizmoAxes>(i % 3);
    const int axis = random.below(3);
    beginDrag(state, handle(GizmoHandle::kMoveX, axis), scene.placement, {600, 300}, scene.context);
    ViewportInput input = pointerAt({650, 333});
    input.typed = "-0,25";
    input.keysPressed = {Key::kEnter};
    const DragResult result = updateDrag(state, input, scene.context);
    EXPECT_EQ(result.outcome, DragOutcome::kCommitted);
    const auto axes = gizmoAxes(state.axes, scene.placement, scene.context.boneInWorld);
    const glm::vec3 expected = -0.25f * axes[static_cast<std::size_t>(axis)];
    EXPECT_LT(glm::length(worldShift(scene, result.placement) - expected), 1e-5f * scene.context.characterHeight);
  }
}

TEST(GizmoRotate, GrabbedDirectionFollowsThePointer) {
  Random random(35);
  int tried = 0;
  for (int i = 0; i < 400; ++i) {
    const GizmoScene scene = test::randomGizmo(random, i % 2 ? BoneScale::kEven : BoneScale::kMirrored);
    GizmoState state;
    state.mode = GizmoMode::kRotate;
    state.axes = static_cast<GizmoAxes>(random.below(3));
    const int axis = random.below(3);
    const GizmoLayout layout = layoutGizmo(state, scene.placement, scene.context);
    const HandleShape* ring = layout.find(handle(GizmoHandle::kRotateX, axis));
    const glm::vec3 normal = layout.axesInWorld[static_cast<std::size_t>(axis)];
    const glm::vec3 origin = scene.originInWorld();
    const Ray sight = scene.context.view.rayThrough(layout.origin);
    if (!ring || std::abs(glm::dot(normal, sight.direction)) < 0.3f) continue;
    const glm::vec2 target = ring->outline[static_cast<std::size_t>(random.below(64))];
    const glm::vec3 grabbed = hitPlane(scene.context.view.rayThrough(ring->anchor), origin, normal) - origin;
    const glm::vec3 wanted = hitPlane(scene.context.view.rayThrough(target), origin, normal) - origin;
    beginDrag(state, ring->handle, scene.placement, ring->anchor, scene.context);
    const DragResult result = updateDrag(state, releasedAt(target), scene.context);
    const glm::mat3 bone(scene.context.boneInWorld);
    const glm::quat inBone = result.placement.rotation * glm::conjugate(scene.placement.rotation);
    const glm::mat3 turned = bone * glm::mat3_cast(inBone) * glm::inverse(bone);
    const float cosine = glm::dot(glm::normalize(turned * grabbed), glm::normalize(wanted));
    EXPECT_GT(cosine, 0.9995f) << i;
    EXPECT_NEAR(glm::length(result.placement.rotation), 1.0f, 1e-5f);
    ++tried;
  }
  EXPECT_GT(tried, 120);
}

TEST(GizmoRotate, UniformScaleGivesTheWorldRotation) {
  Random random(36);
  for (int i = 0; i < 200; ++i) {
    const GizmoScene scene = test::randomGizmo(random, i % 2 ? BoneScale::kEven : BoneScale::kMirrored);
    GizmoState state;
    state.axes = GizmoAxes::kWorld;
    beginDrag(state, GizmoHandle::kRotateY, scene.placement, {600, 300}, scene.context);
    ViewportInput input = releasedAt({600, 300});
    input.typed = "72.5";
    const Placement after = updateDrag(state, input, scene.context).placement;
    const glm::mat3 turn = glm::mat3_cast(glm::angleAxis(72.5f * kHalfTurn / 180.0f, glm::vec3(0, 1, 0)));
    const glm::mat3 expected = turn * glm::mat3(shapeInWorld(scene.placement, 1.0f, scene.context.boneInWorld));
    const glm::mat3 actual(shapeInWorld(after, 1.0f, scene.context.boneInWorld));
    for (int c = 0; c < 3; ++c) {
      EXPECT_LT(glm::length(actual[c] - expected[c]), 1e-5f * scene.context.characterHeight) << i;
    }
  }
}

TEST(GizmoRotate, NonuniformScaleKeepsTheAxisFixed) {
  Random random(37);
  for (int i = 0; i < 200; ++i) {
    const GizmoScene scene = test::randomGizmo(random, BoneScale::kUneven);
    GizmoState state;
    state.axes = GizmoAxes::kWorld;
    beginDrag(state, GizmoHandle::kRotateZ, scene.placement, {600, 300}, scene.context);
    ViewportInput input = releasedAt({600, 300});
    input.typed = "40";
    const Placement after = updateDrag(state, input, scene.context).placement;
    const glm::mat3 bone(scene.context.boneInWorld);
    const glm::mat3 turn =
        bone * glm::mat3_cast(after.rotation * glm::conjugate(scene.placement.rotation)) * glm::inverse(bone);
    EXPECT_LT(glm::length(turn * glm::vec3(0, 0, 1) - glm::vec3(0, 0, 1)), 1e-4f);
    EXPECT_NEAR(turn[0][0] + turn[1][1] + turn[2][2], 1.0f + 2.0f * std::cos(40.0f * kHalfTurn / 180.0f), 1e-4f);
  }
}

TEST(GizmoRotate, EdgeOnRingsRollAlongTheirLine) {
  GizmoScene scene = test::plainGizmo();
  Camera camera;
  camera.stand = {scene.placement.center, 3.0f, 0.0f, 0.0f};
  scene.context.view = viewOf(camera, {1280, 800});
  GizmoState state;
  beginDrag(state, GizmoHandle::kRotateY, scene.placement, {640, 400}, scene.context);
  const DragResult result = updateDrag(state, releasedAt({640 + 95, 400}), scene.context);
  // The front, which faces +Z, goes right: towards +X, one arm's length is one radian.
  const glm::vec3 front = result.placement.rotation * glm::vec3(0, 0, 1);
  EXPECT_NEAR(std::atan2(front.x, front.z), 1.0f, 0.01f);
}

TEST(GizmoRotate, AngleAccumulatesBeyondHalfARevolution) {
  const GizmoScene scene = test::plainGizmo();
  GizmoState state;
  const GizmoLayout layout = layoutGizmo(state, scene.placement, scene.context);
  const auto at = [&](float turns) {
    return layout.origin + 80.0f * glm::vec2(std::cos(2.0f * kHalfTurn * turns), -std::sin(2.0f * kHalfTurn * turns));
  };
  beginDrag(state, GizmoHandle::kRotateScreen, scene.placement, at(0), scene.context);
  for (int i = 1; i <= 30; ++i) {
    static_cast<void>(updateDrag(state, pointerAt(at(0.05f * static_cast<float>(i))), scene.context));
  }
  EXPECT_NEAR(state.drag->angle, 3.0f * kHalfTurn, 0.01f);
}

TEST_P(GizmoDragOnBones, ScaleHandlesChangeOneRadius) {
  Random random(38);
  int tried = 0;
  for (int i = 0; i < 200; ++i) {
    const GizmoScene scene = test::randomGizmo(random, GetParam());
    GizmoState state;
    state.mode = GizmoMode::kScale;
    const int axis = random.below(3);
    if (!layoutGizmo(state, scene.placement, scene.context).find(handle(GizmoHandle::kScaleX, axis))) continue;
    const auto axes = gizmoAxes(GizmoAxes::kPrimitive, scene.placement, scene.context.boneInWorld);
    const glm::vec3 tip = armOf(scene) * axes[static_cast<std::size_t>(axis)];
    const float factor = random.uniform(0.4f, 1.6f);
    const glm::vec3 origin = scene.originInWorld();
    const glm::vec2 press = pixelOf(scene.context.view, origin + tip);
    beginDrag(state, handle(GizmoHandle::kScaleX, axis), scene.placement, press, scene.context);
    const glm::vec2 target = pixelOf(scene.context.view, origin + factor * tip);
    const Placement after = updateDrag(state, releasedAt(target), scene.context).placement;
    EXPECT_NEAR(after.radii[axis] / scene.placement.radii[axis], factor, 0.01f) << i;
    EXPECT_EQ(after.radii[(axis + 1) % 3], scene.placement.radii[(axis + 1) % 3]);
    EXPECT_EQ(after.center, scene.placement.center);
    ++tried;
  }
  EXPECT_GT(tried, 100);
}

TEST(GizmoPoles, PoleDragIsAboutTheCenterDespiteAPivot) {
  GizmoScene scene = test::plainGizmo();
  scene.context.pivotInWorld = glm::vec3(0.3f, 0.5f, 0.1f);
  const GizmoState state;
  const auto pole = basisOfDrag(state, GizmoHandle::kPolePlusX, scene.placement, scene.context);
  const auto ring = basisOfDrag(state, GizmoHandle::kRotateX, scene.placement, scene.context);
  ASSERT_TRUE(pole && ring);
  EXPECT_EQ(pole->origin, scene.placement.center);
  EXPECT_EQ(ring->origin, *scene.context.pivotInWorld);
}

TEST_P(GizmoDragOnBones, PolesFollowThePointerWhileTheOtherEndStays) {
  Random random(39);
  int tried = 0;
  for (int i = 0; i < 400; ++i) {
    const GizmoScene scene = test::randomGizmo(random, GetParam());
    GizmoState state;
    const int axis = random.below(3);
    const float sign = random.chance(0.5f) ? 1.0f : -1.0f;
    const GizmoHandle pole = handle(GizmoHandle::kPolePlusX, 2 * axis + (sign > 0.0f ? 0 : 1));
    if (!layoutGizmo(state, scene.placement, scene.context).find(pole)) continue;
    const auto poleOf = [&](const Placement& placement, float end) {
      glm::vec4 unit(0.0f, 0.0f, 0.0f, 1.0f);
      unit[axis] = end;
      return glm::vec3(shapeInWorld(placement, 1.0f, scene.context.boneInWorld) * unit);
    };
    const glm::vec3 here = poleOf(scene.placement, sign);
    const glm::vec3 opposite = poleOf(scene.placement, -sign);
    const glm::vec3 target = here + random.uniform(-0.3f, 0.8f) * (here - opposite);
    const bool symmetric = random.chance(0.3f);
    beginDrag(state, pole, scene.placement, pixelOf(scene.context.view, here), scene.context);
    ViewportInput input = releasedAt(pixelOf(scene.context.view, target));
    input.alt = symmetric;
    const Placement after = updateDrag(state, input, scene.context).placement;
    const float height = scene.context.characterHeight;
    const float reach = glm::length(here - opposite);
    EXPECT_LT(glm::length(poleOf(after, sign) - target), 0.02f * reach) << i;
    if (symmetric) {
      EXPECT_EQ(after.center, scene.placement.center);
    } else {
      EXPECT_LT(glm::length(poleOf(after, -sign) - opposite), 1e-4f * height);
    }
    EXPECT_EQ(after.rotation, scene.placement.rotation);
    EXPECT_EQ(after.radii[(axis + 1) % 3], scene.placement.radii[(axis + 1) % 3]);
    ++tried;
  }
  EXPECT_GT(tried, 100);
}

TEST_P(GizmoDragOnBones, PolesOfShapesLieOnTheSurfaceAndTheOtherEndStays) {
  Random random(40);
  int tried = 0;
  for (int i = 0; i < 200; ++i) {
    GizmoScene scene = test::randomGizmo(random, GetParam());
    scene.placement.shape = {random.uniform(0.0f, 0.9f),
                             random.uniform(-0.25f, 0.25f),
                             {random.uniform(-0.9f, 0.9f), random.uniform(-0.9f, 0.9f)}};
    GizmoState state;
    const int axis = random.below(3);
    const float sign = random.chance(0.5f) ? 1.0f : -1.0f;
    const GizmoHandle pole = handle(GizmoHandle::kPolePlusX, 2 * axis + (sign > 0.0f ? 0 : 1));
    if (!layoutGizmo(state, scene.placement, scene.context).find(pole)) continue;
    const glm::mat4& bone = scene.context.boneInWorld;
    const auto poleOf = [&](const Placement& placement, float end) {
      return glm::vec3(bone * glm::vec4(placement.center + poleInBone(placement, axis, end), 1.0f));
    };
    const UnitBallMap visible = unitBallMap(scene.placement, 1.0f, bone);
    EXPECT_NEAR(visible.rSquared(poleOf(scene.placement, sign)), 1.0f, 1e-3f) << i;
    const glm::vec3 here = poleOf(scene.placement, sign);
    const glm::vec3 opposite = poleOf(scene.placement, -sign);
    beginDrag(state, pole, scene.placement, pixelOf(scene.context.view, here), scene.context);
    const glm::vec3 target = here + 0.4f * (here - opposite);
    const Placement after = updateDrag(state, releasedAt(pixelOf(scene.context.view, target)), scene.context).placement;
    EXPECT_LT(glm::length(poleOf(after, -sign) - opposite), 1e-4f * scene.context.characterHeight) << i;
    EXPECT_EQ(after.shape, scene.placement.shape);
    ++tried;
  }
  EXPECT_GT(tried, 40);
}

}  // namespace
}  // namespace sinew::app
