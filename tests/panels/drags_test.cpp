// tests/panels/drags_test.cpp: a viewport drag interrupted by panels: what is kept, and what a refused edit leaves.

#include "app/editor/edit.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

using PanelDrags = HeadlessEditor;

TEST_F(PanelDrags, PressOnAPanelCommitsTheGrabAsItsOwnStep) {
  addOne();
  const std::size_t before = steps();
  const glm::vec3 center = muscle().placement.center;
  queue.move(pixelOfBone(0));
  settle();
  run(action("tool/grab"), state);
  settle();
  queue.move(pixelOfBone(0) + glm::vec2(40.0f, 10.0f));
  settle();
  ASSERT_TRUE(ownsKeyboard(state.view.tools));
  const glm::vec3 moved = muscle().placement.center;
  ASSERT_NE(moved, center);
  // Moving the pointer to the field drags the muscle along: only the field's own change comes after that.
  drag("inspector/radius.x", {40.0f, 0.0f});
  EXPECT_FALSE(ownsKeyboard(state.view.tools));
  EXPECT_EQ(steps(), before + 2);
  state.document.commands.undo();
  const Placement kept = muscle().placement;
  EXPECT_NE(kept.center, center);
  state.document.commands.undo();
  EXPECT_EQ(muscle().placement.center, center);
  EXPECT_EQ(muscle().placement.radii, kept.radii);
}

TEST_F(PanelDrags, AcceptedDragClearsTheLastRefusal) {
  addOne();
  refuse(state, Error{"file", "place", "not possible"});
  ASSERT_FALSE(state.open.refusal.empty());
  queue.move(pixelOfBone(0));
  settle();
  run(action("tool/grab"), state);
  settle();
  queue.move(pixelOfBone(0) + glm::vec2(40.0f, 10.0f));
  settle();
  queue.button(0, true);
  queue.button(0, false);
  settle();
  EXPECT_TRUE(state.open.refusal.empty()) << state.open.refusal;
}

}  // namespace
}  // namespace sinew::app
