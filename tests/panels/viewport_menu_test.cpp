// tests/panels/viewport_menu_test.cpp: viewport context menu acts on the object under the pointer.

#include "app/editor/commands.h"

#include <algorithm>

#include "app/editor/symmetry_commands.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

/// A muscle around a bone of the trunk, and a pixel that picks it.
class ViewportContextMenu : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    if (HasFatalFailure()) return;
    state.document.symmetry = false;
    bone = *state.character().skeleton.findBone("spine");
    addMuscle(state, bone);
    ASSERT_EQ(state.document.rig().primitives.size(), 1u);
    state.document.selection.clear();
    settle();
    setTool(state.view.tools, ToolKind::kSelect);
    pixel = pixelOfBone(bone);
  }
  void rightClick(const glm::vec2& at) {
    queue.move(at);
    settle();
    queue.button(1, true);
    queue.button(1, false);
    settle();
  }
  [[nodiscard]] glm::vec2 nothing() const { return glm::vec2(state.frame.viewport) + glm::vec2(120.0f, 140.0f); }
  [[nodiscard]] bool open() const { return shown("context/title"); }
  void choose(const std::string& id) { click("context/" + id); }

  int bone = -1;
  glm::vec2 pixel{0.0f};
};

TEST_F(ViewportContextMenu, OpensOnTheMuscleUnderThePointerAndSelectsIt) {
  EXPECT_FALSE(open());
  rightClick(pixel);
  EXPECT_TRUE(open());
  EXPECT_EQ(state.document.activePrimitive(), 0);
  for (const char* id : {"view/frame", "view/isolate", "view/hide", "edit/mirror", "edit/duplicate", "edit/delete",
                         "tool/territory", "add-here"}) {
    EXPECT_TRUE(shown(std::string("context/") + id)) << id;
    EXPECT_EQ(whyDisabled(state, id), "") << id;
  }
  press(kEscape);
  EXPECT_FALSE(open());
  EXPECT_EQ(state.document.activePrimitive(), 0) << "Esc closed the menu and did nothing else";
}

TEST_F(ViewportContextMenu, EntriesRunActions) {
  rightClick(pixel);
  choose("edit/duplicate");
  EXPECT_EQ(state.document.rig().primitives.size(), 2u);
  EXPECT_FALSE(open());
  rightClick(pixel);
  choose("edit/delete");
  EXPECT_EQ(state.document.rig().primitives.size(), 1u);
  rightClick(pixel);
  choose("view/isolate");
  EXPECT_TRUE(state.document.visibility.isolated.has_value());
  rightClick(pixel);
  choose("view/show-all");
  EXPECT_FALSE(state.document.visibility.isolated.has_value());
  rightClick(pixel);
  choose("tool/territory");
  EXPECT_TRUE(editsTerritory(state));
}

TEST_F(ViewportContextMenu, KeepsASelectionThatContainsTheMuscle) {
  state.document.selection.set(state.document.idAt(0));
  duplicateSelection(state);
  selectAll(state.document);
  settle();
  rightClick(pixel);
  EXPECT_EQ(state.document.selection.primitives.size(), 2u);
  choose("edit/delete");
  EXPECT_TRUE(state.document.rig().primitives.empty());
}

TEST_F(ViewportContextMenu, AddsAMuscleAtThePointOnTheSkin) {
  rightClick(pixel);
  const SkinAnchor anchor = *state.open.viewportMenu.target.skin;
  choose("add-here");
  ASSERT_EQ(state.document.rig().primitives.size(), 2u);
  const Primitive& added = state.document.rig().primitives[1];
  const Pose& pose = state.live->pose();
  const auto on = static_cast<std::size_t>(*state.character().skeleton.findBone(added.bone));
  const glm::vec3 center(pose.boneInWorld[on] * glm::vec4(added.placement.center, 1.0f));
  EXPECT_LT(glm::distance(center, skinPointAt(state.character(), pose, anchor).point),
            0.05f * state.character().height);
  EXPECT_EQ(state.document.activePrimitive(), 1);
  press(kKeyZ, true);
  EXPECT_EQ(state.document.rig().primitives.size(), 1u) << "one step";
}

TEST_F(ViewportContextMenu, MuscleEntriesAreGrayOnBareSkinWithAReason) {
  state.document.selection.set(state.document.idAt(0));
  deleteSelection(state);
  settle();
  rightClick(pixel);
  EXPECT_TRUE(open());
  EXPECT_EQ(state.document.selection.bone, state.open.viewportMenu.target.bone);
  for (const char* id :
       {"view/isolate", "view/hide", "edit/mirror", "edit/duplicate", "edit/delete", "tool/territory"}) {
    EXPECT_NE(whyDisabled(state, id), "") << id;
    EXPECT_FALSE(action(id).enabled(state)) << id;
  }
  const std::size_t before = steps();
  choose("edit/delete");
  EXPECT_EQ(steps(), before);
  choose("edit/add-on-bone");
  EXPECT_EQ(state.document.rig().primitives.size(), 1u);
}

TEST_F(ViewportContextMenu, KeepsTheSelectionOnEmptyBackground) {
  state.document.selection.set(state.document.idAt(0));
  settle();
  rightClick(nothing());
  EXPECT_TRUE(open());
  EXPECT_TRUE(state.open.viewportMenu.target.here.empty());
  EXPECT_EQ(state.document.activePrimitive(), 0);
  EXPECT_TRUE(shown("context/view/frame-all"));
  press(kEscape);
  EXPECT_EQ(state.document.activePrimitive(), 0);
}

TEST_F(ViewportContextMenu, ListsOverlappingMusclesByName) {
  state.document.selection.set(state.document.idAt(0));
  duplicateSelection(state);
  Rig rig = state.document.rig();
  rig.primitives[1].placement.radii *= 0.5f;
  state.document.commands.apply("Shrink", rig);
  settle();
  rightClick(pixel);
  const auto& here = state.open.viewportMenu.target.here;
  ASSERT_GE(here.size(), 2u);
  const std::string other = nameOf(here[1], state.document);
  click("context/select");
  ASSERT_TRUE(shown("context/select/" + other));
  choose("select/" + other);
  EXPECT_EQ(state.document.activeName(), other);
}

TEST_F(ViewportContextMenu, EveryGrayEntryGivesAReason) {
  // Every disabled entry gives a reason, whatever is selected or missing.
  for (const bool muscle : {true, false}) {
    if (!muscle) {
      state.document.selection.set(state.document.idAt(0));
      deleteSelection(state);
      settle();
    }
    rightClick(muscle ? pixel : nothing());
    for (const auto& [id, box] : widgets().rectangles()) {
      if (!id.starts_with("context/")) continue;
      const std::string name = id.substr(8);
      const auto known = std::ranges::find_if(actions(), [&](const Action& a) { return name == a.id; });
      if (known == actions().end() || known->enabled(state)) continue;
      EXPECT_NE(whyDisabled(state, name), "") << name;
    }
    press(kEscape);
  }
}

}  // namespace
}  // namespace sinew::app
