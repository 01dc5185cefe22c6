// tests/viewport/tools/multi_selection_test.cpp: several muscles, twins among them, under one gizmo; box selection; a
// muscle on both sides.

#include <gtest/gtest.h>

#include <cmath>

#include "app/viewport/tools/gizmo.h"
#include "app/viewport/tools/input_router.h"
#include "core/rig/mirror.h"
#include "core/rig/twins.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/support/rigs/rig_copies.h"
#include "tests/viewport/tools/limb_scene.h"

namespace sinew::app {
namespace {

using test::LimbScene;

/// The two-legged body with linked thighs, a belly and a single shin muscle.
struct Legs : LimbScene {
  Legs() : LimbScene(test::makeTwoLegged()) {
    prepareMirror(document);
    const float h = document.character->height;
    Rig rig;
    const auto muscle = [&](const char* name, const char* bone, const glm::vec3& center) {
      Primitive primitive;
      primitive.name = name;
      primitive.bone = bone;
      primitive.placement = {center * h, glm::angleAxis(0.4f, glm::normalize(glm::vec3(1, 2, 3))),
                             glm::vec3(0.05f, 0.09f, 0.06f) * h};
      return primitive;
    };
    rig = addPair(rig, muscle("thigh L", "leg L", {0.01f, -0.05f, 0.02f}), *document.mirror).value();
    rig = addPrimitive(rig, muscle("belly", "spine", {0.02f, 0.05f, 0.02f})).value();
    rig = addPrimitive(rig, muscle("shin", "shin R", {0.0f, -0.05f, 0.0f})).value();
    document.commands.apply("Set up", rig);
  }

  [[nodiscard]] const Primitive& primitive(const std::string& name) const {
    return document.rig().primitives[static_cast<std::size_t>(findPrimitive(document.rig(), name))];
  }
  [[nodiscard]] const glm::mat4& boneOf(const std::string& name) const {
    return pose.boneInWorld[static_cast<std::size_t>(*document.character->skeleton.findBone(primitive(name).bone))];
  }
  [[nodiscard]] glm::vec3 centerInWorld(const std::string& name) const {
    return glm::vec3(boneOf(name) * glm::vec4(primitive(name).placement.center, 1.0f));
  }
  void expectTwinsExact() const {
    const Result<Primitive> image = mirroredPrimitive(*document.mirror, primitive("thigh L"));
    ASSERT_TRUE(image);
    const Placement& twin = primitive("thigh R").placement;
    EXPECT_LT(glm::length(image->placement.center - twin.center), 1e-5f);
    EXPECT_LT(glm::length(image->placement.radii - twin.radii), 1e-6f);
    EXPECT_GT(std::abs(glm::dot(image->placement.rotation, twin.rotation)), 1.0f - 1e-5f);
  }
  void setMode(GizmoHandle handle) {
    switch (partsOf(handle).kind) {
      case HandleKind::kMove:
        setTool(tools, ToolKind::kMove);
        break;
      case HandleKind::kRotate:
        setTool(tools, ToolKind::kRotate);
        break;
      case HandleKind::kScale:
        setTool(tools, ToolKind::kScale);
        break;
      default:
        setTool(tools, ToolKind::kSelect);
        break;
    }
  }
};

constexpr GizmoAxes kAllAxes[] = {GizmoAxes::kWorld, GizmoAxes::kBone, GizmoAxes::kPrimitive};

/// Keyboard input during the drag.
enum class Manner { kPlain, kTyped, kLocked, kSnapped, kPrecise, kEscape, kRightButton };
constexpr Manner kManners[] = {Manner::kPlain,   Manner::kTyped,  Manner::kLocked,     Manner::kSnapped,
                               Manner::kPrecise, Manner::kEscape, Manner::kRightButton};

/// Drags a handle; false if it cannot be grabbed from here.
bool dragHandle(Legs& scene, GizmoHandle handle, Manner manner) {
  const RouteResult seen = scene.move({5, 5});
  const HandleShape* const shape = seen.gizmo.find(handle);
  if (!shape) return false;
  const glm::vec2 from = shape->anchor;
  const glm::vec2 to = from + glm::vec2(47, -31);
  scene.move(from);
  if (scene.tools.gizmo.hovered != handle) return false;
  scene.press(from);
  scene.drag(0.5f * (from + to));
  ViewportInput keys;
  if (manner == Manner::kTyped) keys.typed = "0.3";
  if (manner == Manner::kLocked) keys.keysPressed = {Key::kY};
  if (manner == Manner::kSnapped) keys.ctrl = true;
  if (manner == Manner::kPrecise) keys.shift = true;
  if (manner == Manner::kEscape) keys.keysPressed = {Key::kEscape};
  if (manner == Manner::kRightButton) keys.buttons[1] = {true, true, false, false};
  scene.drag(to, MouseButton::kLeft, keys);
  scene.expectTwinsExact();
  keys.typed.clear();
  keys.keysPressed.clear();
  scene.release(to, MouseButton::kLeft, keys);
  return true;
}

/// Compares the effect of dragging `handle` on the other muscles with that on the active one.
void expectTogether(const Legs& scene, const Legs& before, GizmoHandle handle, const std::string& active) {
  const HandleKind kind = partsOf(handle).kind;
  for (const char* name : {"belly", "shin"}) {
    if (name == active) continue;
    const Placement& start = before.primitive(name).placement;
    const Placement& now = scene.primitive(name).placement;
    if (kind == HandleKind::kPole) {
      EXPECT_EQ(start.radii, now.radii);
    }
    if (kind == HandleKind::kMove) {
      const glm::vec3 own = scene.centerInWorld(name) - before.centerInWorld(name);
      const glm::vec3 lead = scene.centerInWorld(active) - before.centerInWorld(active);
      EXPECT_LT(glm::length(own - lead), 1e-4f) << name;
      EXPECT_EQ(start.rotation, now.rotation);
    }
    if (kind == HandleKind::kRotate) {
      // Distances between the muscles stay, and all rotate by one angle.
      EXPECT_NEAR(glm::distance(scene.centerInWorld(name), scene.centerInWorld(active)),
                  glm::distance(before.centerInWorld(name), before.centerInWorld(active)), 1e-4f);
      const Placement& leadStart = before.primitive(active).placement;
      const Placement& leadNow = scene.primitive(active).placement;
      EXPECT_NEAR(std::abs(glm::dot(start.rotation, now.rotation)),
                  std::abs(glm::dot(leadStart.rotation, leadNow.rotation)), 1e-4f);
    }
    if (kind == HandleKind::kScale) {
      const glm::vec3 lead = scene.primitive(active).placement.radii / before.primitive(active).placement.radii;
      EXPECT_LT(glm::length(now.radii / start.radii - lead), 1e-3f);
      EXPECT_EQ(start.center, now.center);
    }
  }
}

TEST(MultiSelection, EveryHandleMovesTheSelectionAndTwinsOnce) {
  int scenes = 0, dragged = 0;
  const Legs before;
  for (int h = 1; h < kGizmoHandleCount; ++h) {
    const auto handle = static_cast<GizmoHandle>(h);
    for (const GizmoAxes axes : kAllAxes) {
      for (const Manner manner : kManners) {
        Legs scene;
        select(scene.document, {"thigh R", "shin", "belly", "thigh L"});
        if (h % 2 == 0) std::swap(scene.document.selection.primitives[2], scene.document.selection.primitives[3]);
        scene.tools.gizmo.axes = axes;
        scene.tools.pivot = (scenes++ + h) % 2 == 0 ? GizmoPivot::kActive : GizmoPivot::kCentroid;
        scene.setMode(handle);
        if (!dragHandle(scene, handle, manner)) continue;
        ++dragged;
        const bool canceled = manner == Manner::kEscape || manner == Manner::kRightButton;
        if (canceled) {
          EXPECT_TRUE(scene.document.rig() == before.document.rig()) << nameOf(handle);
        }
        EXPECT_LE(scene.document.commands.stepCount(), canceled ? 1u : 2u);
        expectTogether(scene, before, handle, scene.document.activeName());
        scene.expectTwinsExact();
        if (!canceled && scene.document.commands.stepCount() == 2) scene.document.commands.undo();
        EXPECT_TRUE(scene.document.rig() == before.document.rig()) << nameOf(handle);
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(dragged, 200);
}

TEST(MultiSelection, DragFrameCopiesTheRigOnce) {
  Legs scene;
  select(scene.document, {"thigh R", "shin", "belly"});
  scene.setMode(GizmoHandle::kMoveCenter);
  const HandleShape* const shape = scene.move({5, 5}).gizmo.find(GizmoHandle::kMoveCenter);
  ASSERT_TRUE(shape);
  const glm::vec2 from = shape->anchor;
  scene.move(from);
  scene.press(from);
  scene.drag(from + glm::vec2(20, 10));
  const std::size_t before = scene.document.commands.revision();
  const test::RigCopies copies(scene.document.rig());
  scene.drag(from + glm::vec2(30, -10));
  EXPECT_EQ(copies.count(), 1);
  EXPECT_EQ(scene.document.commands.revision(), before + 1);
  EXPECT_EQ(scene.tools.companions.size(), 2u);
}

TEST(MultiSelection, OnlyOneOfTwoSelectedTwinsIsMovedDirectly) {
  Legs scene;
  select(scene.document, {"thigh R", "thigh L"});
  const int active = findPrimitive(scene.document.rig(), "thigh L");
  EXPECT_TRUE(companionsOf(scene.document, active).empty());
  select(scene.document, {"thigh R", "thigh L", "belly"});
  const auto companions = companionsOf(scene.document, findPrimitive(scene.document.rig(), "belly"));
  ASSERT_EQ(companions.size(), 1u);
  EXPECT_EQ(companions[0].primitive, idOf(scene.document, "thigh R"));
  scene.document.visibility.setMuscle(Mark::kLocked, idOf(scene.document, "thigh R"), true);
  EXPECT_EQ(companionsOf(scene.document, findPrimitive(scene.document.rig(), "belly"))[0].primitive,
            idOf(scene.document, "thigh L"));
}

ViewportInput with(bool ctrl, bool shift = false, bool alt = false) {
  ViewportInput input;
  input.ctrl = ctrl;
  input.shift = shift;
  input.alt = alt;
  return input;
}

void drawBoxOver(Legs& scene, const glm::vec2& from, const glm::vec2& to, const ViewportInput& keys) {
  ViewportInput hover = keys;
  hover.mouse = from;
  scene.frame(hover);
  scene.press(from, MouseButton::kLeft, keys);
  scene.drag(0.5f * (from + to), MouseButton::kLeft, keys);
  EXPECT_TRUE(scene.tools.box.drag);
  scene.release(to, MouseButton::kLeft, keys);
  EXPECT_FALSE(scene.tools.box.drag);
}

TEST(BoxSelect, SelectsTouchedMusclesAndAddsOrRemoves) {
  Legs scene;
  const glm::vec2 all(999, 799);
  drawBoxOver(scene, {1, 1}, all, with(true));
  EXPECT_EQ(selectedNames(scene.document), (std::vector<std::string>{"thigh L", "thigh R", "belly", "shin"}));
  EXPECT_EQ(scene.document.commands.stepCount(), 1u);
  const View view = viewOf(scene.tools.camera, LimbScene::kSize);
  const glm::vec2 shin(view.toPixel(scene.centerInWorld("shin")));
  const glm::vec2 some(6, 6);
  scene.document.selection.clear();
  drawBoxOver(scene, shin - some, shin + some, with(true));
  EXPECT_EQ(selectedNames(scene.document), std::vector<std::string>{"shin"});
  const glm::vec2 belly(view.toPixel(scene.centerInWorld("belly")));
  select(scene.document, {"thigh L"});
  armBox(scene.tools);
  EXPECT_TRUE(ownsKeyboard(scene.tools));
  drawBoxOver(scene, belly + some, belly - some, with(false, true));
  EXPECT_EQ(scene.document.activeName(), "belly");
  EXPECT_TRUE(scene.document.selection.contains(idOf(scene.document, "thigh L")));
  armBox(scene.tools);
  drawBoxOver(scene, {1, 1}, all, with(false, false, true));
  EXPECT_TRUE(scene.document.selection.primitives.empty());
}

TEST(BoxSelect, EscapeKeepsTheSelectionAndHiddenMusclesAreSkipped) {
  Legs scene;
  select(scene.document, {"shin"});
  scene.press({1, 1}, MouseButton::kLeft, with(true));
  scene.drag({900, 700}, MouseButton::kLeft, with(true));
  ViewportInput escape = with(true);
  escape.keysPressed = {Key::kEscape};
  scene.drag({900, 700}, MouseButton::kLeft, escape);
  scene.release({900, 700});
  EXPECT_EQ(selectedNames(scene.document), std::vector<std::string>{"shin"});
  EXPECT_FALSE(ownsKeyboard(scene.tools));
  scene.document.visibility.setMuscle(Mark::kHidden, idOf(scene.document, "belly"), true);
  drawBoxOver(scene, {1, 1}, {999, 799}, with(true));
  EXPECT_FALSE(scene.document.selection.contains(idOf(scene.document, "belly")));
  EXPECT_EQ(scene.document.selection.primitives.size(), 3u);
  scene.document.visibility.setMuscle(Mark::kHidden, idOf(scene.document, "belly"), false);
  scene.document.visibility.setMuscle(Mark::kLocked, idOf(scene.document, "belly"), true);
  drawBoxOver(scene, {1, 1}, {999, 799}, with(true));
  EXPECT_FALSE(scene.document.selection.contains(idOf(scene.document, "belly"))) << "a locked muscle";
}

TEST(AddMuscleOnBothSides, AddsATwinInTheSameStepOrOneInTheMiddle) {
  Legs scene;
  ASSERT_TRUE(scene.document.symmetry);
  const Skeleton& skeleton = scene.document.character->skeleton;
  const std::size_t before = scene.document.rig().primitives.size();
  const Result<std::string> name = addMuscleOnBone(scene.document, *skeleton.findBone("shin L"));
  ASSERT_TRUE(name);
  EXPECT_EQ(scene.document.rig().primitives.size(), before + 2);
  EXPECT_EQ(scene.document.commands.stepCount(), 2u);
  EXPECT_EQ(scene.primitive(name.value()).mirror, "shin R muscle");
  EXPECT_EQ(selectedNames(scene.document), std::vector<std::string>{name.value()});
  ASSERT_TRUE(addMuscleOnBone(scene.document, *skeleton.findBone("spine")));
  EXPECT_EQ(scene.document.rig().primitives.size(), before + 3);
  EXPECT_TRUE(liesInPlane(*scene.document.mirror, scene.document.rig().primitives.back(), 1e-4f));
  scene.document.symmetry = false;
  ASSERT_TRUE(addMuscleOnBone(scene.document, *skeleton.findBone("shin L")));
  EXPECT_EQ(scene.document.rig().primitives.size(), before + 4);
}

TEST(AddMuscleOnBothSides, TwinFollowsTheDragAndIsRemovedByEscape) {
  Legs scene;
  setTool(scene.tools, ToolKind::kAddMuscle);
  const View view = viewOf(scene.tools.camera, LimbScene::kSize);
  const glm::vec2 pixel = glm::round(glm::vec2(view.toPixel(scene.centerInWorld("thigh L"))));
  const std::size_t before = scene.document.rig().primitives.size();
  scene.move(pixel);
  scene.press(pixel);
  scene.drag(pixel + glm::vec2(0, 60));
  ASSERT_EQ(scene.document.rig().primitives.size(), before + 2);
  const Primitive grown = scene.document.rig().primitives[before];
  const Result<Primitive> image = mirroredPrimitive(*scene.document.mirror, grown);
  EXPECT_LT(glm::length(image->placement.radii - scene.document.rig().primitives[before + 1].placement.radii), 1e-6f);
  ViewportInput escape;
  escape.keysPressed = {Key::kEscape};
  scene.drag(pixel + glm::vec2(0, 70), MouseButton::kLeft, escape);
  EXPECT_EQ(scene.document.rig().primitives.size(), before);
}

}  // namespace
}  // namespace sinew::app
