// tests/viewport/tools/sheet_selection_test.cpp: a sheet is picked, boxed and shown as one muscle, with handles on its
// edges.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/document/listed_muscles.h"
#include "core/rig/twins.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/viewport/tools/sheet_scene.h"

namespace sinew::app {
namespace {

using test::SheetScene;

constexpr std::size_t kBellies = 9;

/// Off the handles of the edges.
glm::vec2 middleOf(const SheetScene& scene) { return scene.pixelOfBelly(4); }

TEST(SheetSelection, AClickTakesAllBelliesAndTheFirstIsActive) {
  SheetScene scene;
  scene.click(middleOf(scene));
  EXPECT_EQ(scene.document.selection.primitives.size(), kBellies);
  EXPECT_EQ(scene.document.activePrimitive(), 0);
  EXPECT_EQ(scene.document.activeName(), "plate");
  EXPECT_EQ(activeSheet(scene.document), 0);
  const std::vector<PrimitiveShape> shapes = primitiveShapes(scene.document, scene.pose);
  EXPECT_TRUE(std::ranges::all_of(shapes, &PrimitiveShape::selected));
}

TEST(SheetSelection, IsOneThingUnderThePointer) {
  SheetScene scene;
  const RouteResult seen = scene.move(middleOf(scene));
  const auto muscles =
      std::ranges::count_if(scene.tools.hover.here, [](const PickEntry& entry) { return bool(entry.muscle); });
  EXPECT_EQ(muscles, 1);
  EXPECT_TRUE(seen.status.starts_with("plate on root")) << seen.status;
}

TEST(SheetSelection, ShiftClickAddsAndRemovesAll) {
  SheetScene scene;
  ViewportInput shift;
  shift.shift = true;
  scene.click(middleOf(scene), shift);
  EXPECT_EQ(scene.document.selection.primitives.size(), kBellies);
  scene.click(middleOf(scene), shift);
  EXPECT_TRUE(scene.document.selection.primitives.empty());
}

TEST(SheetSelection, ABoxOverOneBellyTakesAllAndRemovesAll) {
  SheetScene scene;
  const View view = viewOf(scene.tools.camera, SheetScene::kSize);
  const glm::vec2 at = scene.pixelOfBelly(0);
  BoxDrag box{at - 3.0f, at + 3.0f, BoxMode::kReplace};
  selectBox(scene.context(), view, box);
  EXPECT_EQ(scene.document.selection.primitives.size(), kBellies);
  box.mode = BoxMode::kRemove;
  selectBox(scene.context(), view, box);
  EXPECT_TRUE(scene.document.selection.primitives.empty());
}

TEST(SheetSelection, HasNoGizmoAndDoesNotMoveWithOthers) {
  SheetScene scene;
  Primitive single;
  single.name = "single";
  single.bone = "middle";
  single.placement.radii = glm::vec3(0.1f);
  scene.document.commands.apply("Add", addPrimitive(scene.document.rig(), single).value());
  selectMuscle(scene.document, findPrimitive(scene.document.rig(), "plate 1.1"));
  EXPECT_FALSE(scene.move({5, 5}).gizmo.visible);
  scene.document.selection.primitives.push_back(idOf(scene.document, "single"));
  EXPECT_TRUE(scene.move({5, 5}).gizmo.visible);
  EXPECT_TRUE(companionsOf(scene.document, scene.document.activePrimitive()).empty());
}

TEST(SheetEdges, ADraggedPointFollowsTheSkinInOneStep) {
  SheetScene scene;
  selectMuscle(scene.document, 0);
  const std::size_t before = scene.document.commands.position();
  const LineAnchor start = scene.sheet().edges[1].points[1];
  const std::vector<Primitive> bellies = scene.document.rig().primitives;
  const glm::vec2 from = scene.pixelOf(start);
  const RouteResult hovered = scene.move(from + glm::vec2(2, 1));
  ASSERT_TRUE(scene.tools.sheetHandles.hovered);
  EXPECT_EQ(*scene.tools.sheetHandles.hovered, (EdgePoint{1, 1}));
  EXPECT_TRUE(hovered.status.starts_with("The insertion of plate")) << hovered.status;
  scene.press(from + glm::vec2(2, 1));
  scene.drag(from + glm::vec2(2, 41));
  const RouteResult moving = scene.drag(from + glm::vec2(2, 81));
  EXPECT_TRUE(moving.status.starts_with("Moving the insertion")) << moving.status;
  scene.release(from + glm::vec2(2, 81));
  EXPECT_EQ(scene.document.commands.position(), before + 1);
  EXPECT_EQ(scene.document.commands.label(before + 1), "Move insertion of plate");
  const glm::vec3 now = scene.inWorld(scene.sheet().edges[1].points[1]);
  EXPECT_LT(glm::distance(scene.pixelOf(now), from + glm::vec2(0, 80)), 12.0f) << "under the pointer, but on bare skin";
  const SheetSkin skin(scene.document.character, Rig{});
  EXPECT_LT(glm::distance(skin.nearest(now), now), 0.01f * scene.document.character->height);
  EXPECT_NE(scene.document.rig().primitives, bellies) << "laid again";
  EXPECT_EQ(scene.document.selection.primitives.size(), kBellies);
}

TEST(SheetEdges, EscRestoresAndBesideTheBodyThePointStays) {
  SheetScene scene;
  selectMuscle(scene.document, 0);
  const Rig before = scene.document.rig();
  const glm::vec2 from = scene.pixelOf(scene.sheet().edges[0].points[1]);
  scene.move(from);
  scene.press(from);
  scene.drag(from + glm::vec2(0, -30));
  const LineAnchor moved = scene.sheet().edges[0].points[1];
  EXPECT_NE(moved, before.sheets[0].edges[0].points[1]);
  scene.drag({2, 2});
  EXPECT_EQ(scene.sheet().edges[0].points[1], moved);
  ViewportInput escape;
  escape.keysPressed = {Key::kEscape};
  scene.drag({2, 2}, MouseButton::kLeft, escape);
  EXPECT_EQ(scene.document.rig(), before);
  scene.release({2, 2});
  EXPECT_EQ(scene.document.rig(), before);
}

TEST(SheetEdges, TheTwinFollows) {
  SheetScene scene(test::makeTwoLegged(), "leg L", "shin L");
  scene.document.commands.apply("Mirror",
                                mirrorSheetToOtherSide(scene.document.rig(), 0, *scene.document.mirror).value());
  ASSERT_EQ(scene.document.rig().sheets.size(), 2u);
  selectMuscle(scene.document, 0);
  const glm::vec2 from = scene.pixelOf(scene.sheet().edges[0].points[1]);
  scene.move(from);
  scene.press(from);
  scene.drag(from + glm::vec2(0, 25));
  scene.release(from + glm::vec2(0, 25));
  const LineAnchor image = mirroredAnchor(*scene.document.mirror, scene.sheet(0).edges[0].points[1]).value();
  EXPECT_EQ(scene.sheet(1).edges[0].points[1].bone, image.bone);
  EXPECT_LT(glm::distance(scene.sheet(1).edges[0].points[1].point, image.point), 1e-5f);
}

TEST(SheetEdges, AreNotShownWhenTheSheetIsLockedOrHidden) {
  SheetScene scene;
  selectMuscle(scene.document, 0);
  EXPECT_TRUE(shownSheet(scene.document, scene.pose));
  for (const Mark mark : {Mark::kHidden, Mark::kLocked}) {
    scene.document.visibility.setMuscle(mark, scene.document.idAt(0), true);
    EXPECT_FALSE(shownSheet(scene.document, scene.pose));
    scene.document.visibility.setMuscle(mark, scene.document.idAt(0), false);
  }
}

}  // namespace
}  // namespace sinew::app
