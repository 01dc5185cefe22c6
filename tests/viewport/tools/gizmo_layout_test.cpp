// tests/viewport/tools/gizmo_layout_test.cpp: handles can be found, named and hit.

#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/viewport/tools/random_gizmo.h"

namespace sinew::app {
namespace {

using test::BoneScale;
using test::GizmoScene;
using test::Random;

std::set<std::string> namesOf(const GizmoLayout& layout) {
  std::set<std::string> names;
  for (const auto& [name, pixel] : layout.namedPixels()) names.insert(name);
  return names;
}

const std::set<std::string> kPoles = {"pole.+x", "pole.-x", "pole.+y", "pole.-y", "pole.+z", "pole.-z"};

std::set<std::string> withPoles(std::set<std::string> names) {
  names.insert(kPoles.begin(), kPoles.end());
  return names;
}

class GizmoModes : public ::testing::TestWithParam<GizmoMode> {};

TEST_P(GizmoModes, EveryNamedPixelHitsItsOwnHandle) {
  Random random(21);
  int handles = 0;
  for (int i = 0; i < 400; ++i) {
    const GizmoScene scene = test::randomGizmo(random, static_cast<BoneScale>(i % 3));
    GizmoState state;
    state.mode = GetParam();
    state.axes = static_cast<GizmoAxes>(random.below(3));
    const GizmoLayout layout = layoutGizmo(state, scene.placement, scene.context);
    std::set<GizmoHandle> seen;
    for (const HandleShape& shape : layout.handles) {
      EXPECT_STREQ(nameOf(hitTest(layout, shape.anchor)), nameOf(shape.handle)) << i;
      EXPECT_TRUE(seen.insert(shape.handle).second);
      EXPECT_EQ(shape.anchor, glm::round(shape.anchor));
      EXPECT_TRUE(shape.anchor.x >= 0 && shape.anchor.y >= 0 && shape.anchor.x < 1280 && shape.anchor.y < 800);
      ++handles;
    }
    EXPECT_EQ(layout.namedPixels().size(), layout.handles.size());
  }
  EXPECT_GT(handles, 400 * 4);
}

INSTANTIATE_TEST_SUITE_P(All, GizmoModes,
                         ::testing::Values(GizmoMode::kPoles, GizmoMode::kMove, GizmoMode::kRotate, GizmoMode::kScale),
                         [](const auto& mode) { return std::string(nameOf(mode.param)); });

TEST(GizmoLayout, GeneralViewShowsEveryHandle) {
  const GizmoScene scene = test::plainGizmo();
  const std::set<std::string> move = {"move.x", "move.y", "move.z", "move.xy", "move.yz", "move.zx", "move.center"};
  const std::set<std::string> rotate = {"rotate.x", "rotate.y", "rotate.z", "rotate.screen"};
  const std::set<std::string> scale = {"scale.x", "scale.y", "scale.z", "scale.uniform"};
  GizmoState state;
  state.mode = GizmoMode::kMove;
  EXPECT_EQ(namesOf(layoutGizmo(state, scene.placement, scene.context)), withPoles(move));
  state.mode = GizmoMode::kRotate;
  EXPECT_EQ(namesOf(layoutGizmo(state, scene.placement, scene.context)), withPoles(rotate));
  state.mode = GizmoMode::kScale;
  EXPECT_EQ(namesOf(layoutGizmo(state, scene.placement, scene.context)), withPoles(scale));
  state.mode = GizmoMode::kPoles;
  EXPECT_EQ(namesOf(layoutGizmo(state, scene.placement, scene.context)), kPoles);
}

TEST(GizmoLayout, AxesTowardsTheEyeAndEdgeOnPlanesAreHidden) {
  GizmoScene scene = test::plainGizmo();
  Camera camera;
  camera.stand = {scene.placement.center, 3.0f, 0.0f, 0.0f};  // Along -Z.
  scene.context.view = viewOf(camera, {1280, 800});
  const std::set<std::string> names = namesOf(layoutGizmo(GizmoState{}, scene.placement, scene.context));
  EXPECT_EQ(names, (std::set<std::string>{"move.x", "move.y", "move.xy", "move.center", "pole.+x", "pole.-x", "pole.+y",
                                          "pole.-y"}));
}

TEST(GizmoLayout, SizeOnScreenIsConstant) {
  for (const float height : {1.8f, 155.0f}) {
    for (const float distance : {1.0f, 2.0f, 8.0f}) {
      for (const float uiScale : {1.0f, 1.5f}) {
        Camera camera;
        camera.characterHeight = height;
        camera.stand = {glm::vec3(0.0f), distance * height, 0.0f, 0.0f};
        Placement placement;
        placement.radii = glm::vec3(0.01f * height);
        const GizmoContext context{viewOf(camera, {1280, 800}), glm::mat4(1.0f), height, uiScale};
        const GizmoLayout layout = layoutGizmo(GizmoState{}, placement, context);
        const HandleShape* arrow = layout.find(GizmoHandle::kMoveX);
        ASSERT_NE(arrow, nullptr);
        EXPECT_NEAR(glm::length(arrow->outline[1] - layout.origin), 95.0f * uiScale, 0.5f);
      }
    }
  }
}

TEST(GizmoLayout, PolesLieOnTheDrawnEllipsoid) {
  Random random(22);
  int seen = 0;
  for (int i = 0; i < 100; ++i) {
    const GizmoScene scene = test::randomGizmo(random, BoneScale::kUneven);
    const GizmoLayout layout = layoutGizmo(GizmoState{}, scene.placement, scene.context);
    const glm::mat4 shape = shapeInWorld(scene.placement, 1.0f, scene.context.boneInWorld);
    for (int axis = 0; axis < 3; ++axis) {
      const auto plus = static_cast<GizmoHandle>(static_cast<int>(GizmoHandle::kPolePlusX) + 2 * axis);
      const HandleShape* pole = layout.find(plus);
      if (!pole) continue;
      glm::vec4 unit(0.0f, 0.0f, 0.0f, 1.0f);
      unit[axis] = 1.0f;
      EXPECT_LT(glm::length(pole->outline[0] - test::pixelOf(scene.context.view, glm::vec3(shape * unit))), 0.05f);
      ++seen;
    }
  }
  EXPECT_GT(seen, 100);
}

TEST(GizmoLayout, RingsAreGrabbedOnTheHalfFacingTheEye) {
  Random random(23);
  for (int i = 0; i < 200; ++i) {
    const GizmoScene scene = test::randomGizmo(random, BoneScale::kEven);
    GizmoState state;
    state.mode = GizmoMode::kRotate;
    const GizmoLayout layout = layoutGizmo(state, scene.placement, scene.context);
    for (const HandleShape& ring : layout.handles) {
      if (ring.inFront.empty()) continue;
      float nearest = 1e9f;
      for (std::size_t k = 0; k < ring.outline.size(); ++k) {
        if (ring.inFront[k]) nearest = std::min(nearest, glm::length(ring.outline[k] - ring.anchor));
      }
      EXPECT_LE(nearest, 1.0f) << nameOf(ring.handle);
    }
  }
}

TEST(GizmoLayout, IsHiddenOnAFlattenedBoneOrBehindTheEye) {
  GizmoScene scene = test::plainGizmo();
  scene.context.boneInWorld = glm::scale(glm::mat4(1.0f), glm::vec3(1.0f, 0.0f, 1.0f));
  EXPECT_FALSE(layoutGizmo(GizmoState{}, scene.placement, scene.context).visible);
  scene = test::plainGizmo();
  scene.placement.center = scene.context.view.eyeInWorld - scene.context.view.forwardInWorld();
  const GizmoLayout behind = layoutGizmo(GizmoState{}, scene.placement, scene.context);
  EXPECT_FALSE(behind.visible);
  EXPECT_EQ(hitTest(behind, {640, 400}), GizmoHandle::kNone);
}

TEST(GizmoLayout, NothingIsHitFarFromTheHandles) {
  const GizmoScene scene = test::plainGizmo();
  const GizmoLayout layout = layoutGizmo(GizmoState{}, scene.placement, scene.context);
  EXPECT_EQ(hitTest(layout, {3, 3}), GizmoHandle::kNone);
}

}  // namespace
}  // namespace sinew::app
