// tests/panels/keyboard_focus_test.cpp: Tab and arrows reach every control, with a visible focus ring; Esc goes back
// one level.

#include "app/ui/keyboard_focus.h"

#include <imgui.h>
#include <imgui_internal.h>  // ImGui's focused item.

#include <algorithm>
#include <map>
#include <set>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

class KeyboardFocus : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    addOne();
    queue.move({-10.0f, -10.0f});
    settle();
  }
  void tab(bool back = false) {
    if (back) queue.key(GLFW_KEY_LEFT_SHIFT, true);
    press(GLFW_KEY_TAB);
    if (back) queue.key(GLFW_KEY_LEFT_SHIFT, false);
    settle();
  }
  static unsigned focused() { return focusShown() ? ImGui::GetCurrentContext()->NavId : 0; }
  [[nodiscard]] const LaidOut* laidOut(unsigned item) const {
    const auto& all = widgets().laidOut();
    const auto found = std::ranges::find(all, item, &LaidOut::item);
    return found == all.end() ? nullptr : &*found;
  }
  [[nodiscard]] std::string focusedId() const {
    const LaidOut* const control = focused() == 0 ? nullptr : laidOut(focused());
    return control == nullptr ? "" : control->id;
  }
  /// Presses Tab until the control has the ring.
  void focus(const std::string& id) {
    for (int i = 0; i < 400 && focusedId() != id; ++i) tab();
    ASSERT_EQ(focusedId(), id);
  }
};

TEST_F(KeyboardFocus, TabVisitsEveryControlAndScrollsItIntoView) {
  for (const auto& [tabId, leftTab] :
       {std::pair{"outliner/tab", LeftTab::kMuscles}, std::pair{"blending/tab", LeftTab::kGroups},
        std::pair{"library/tab", LeftTab::kLibrary}}) {
    state.view.outliner.tab = leftTab;
    settle();
    std::set<std::string> wanted;
    for (const LaidOut& control : widgets().laidOut()) {
      if (control.item != 0 && control.usable && control.visible.z >= 3.0f && control.visible.w >= 3.0f)
        wanted.insert(control.id);
    }
    EXPECT_GT(wanted.size(), 60u);
    std::set<std::string> reached;
    tab();
    const std::string first = focusedId();
    ASSERT_NE(first, "");
    for (int i = 0; i < 500; ++i) {
      const LaidOut* const control = laidOut(focused());
      ASSERT_NE(control, nullptr) << "the ring is on nothing after " << i;
      EXPECT_GE(control->visible.z, 3.0f) << control->id;
      EXPECT_GE(control->visible.w, 3.0f) << control->id;
      reached.insert(control->id);
      tab();
      if (focusedId() == first) break;
    }
    EXPECT_EQ(focusedId(), first) << "it does not come round";
    for (const std::string& id : wanted) EXPECT_TRUE(reached.contains(id)) << id << " is not reached, tab " << tabId;
    press(kEscape);
    EXPECT_EQ(focused(), 0u);
  }
}

TEST_F(KeyboardFocus, ShiftTabGoesBackAndCtrlTabChangesPanels) {
  tab();
  tab();
  const unsigned second = focused();
  tab();
  EXPECT_NE(focused(), second);
  tab(true);
  EXPECT_EQ(focused(), second);
  std::set<std::string> panels;
  for (int i = 0; i < 12; ++i) {
    ASSERT_NE(focusedId(), "") << "after " << i;
    const std::string panel = ImGui::GetCurrentContext()->NavWindow->RootWindow->Name;
    EXPECT_EQ(panel.find("layout"), std::string::npos) << panel;
    panels.insert(panel);
    press(GLFW_KEY_TAB, true);
    EXPECT_NE(ImGui::GetCurrentContext()->NavWindow->RootWindow->Name, panel) << "the same panel again";
  }
  for (const char* panel : {"region-outliner", "region-history", "region-right", "region-viewport", "region-bottom"}) {
    EXPECT_TRUE(panels.contains(panel)) << panel;
  }
}

TEST_F(KeyboardFocus, SpaceAndEnterPressButtonsAndEnterTypesNumbers) {
  focus("toolstrip/rotate");
  press(kSpace);
  EXPECT_EQ(state.view.tools.tool, ToolKind::kRotate);
  EXPECT_FALSE(state.open.transport.playing) << "Space has played as well";
  focus("toolstrip/scale");
  press(kEnter);
  EXPECT_EQ(state.view.tools.tool, ToolKind::kScale);
  focus("inspector/reach");
  press(kEnter);
  press(kKeyA, true);
  type("3");
  press(kEnter);
  EXPECT_FLOAT_EQ(muscle().reach, 3.0f);
  EXPECT_EQ(steps(), 2u);
}

TEST_F(KeyboardFocus, ArrowsChangeANumberInOneStepAndEscapeRevertsIt) {
  focus("surface/iso");
  const float before = state.document.rig().surface.iso;
  press(kSpace);
  for (int i = 0; i < 3; ++i) press(GLFW_KEY_RIGHT);
  EXPECT_GT(state.document.rig().surface.iso, before);
  press(kSpace);
  EXPECT_EQ(steps(), 2u);
  press(kSpace);
  press(GLFW_KEY_RIGHT);
  press(kEscape);
  EXPECT_EQ(steps(), 2u) << "Esc has kept it";
  EXPECT_EQ(focusedId(), "surface/iso") << "Esc has taken two steps";
  press(kEscape);
  EXPECT_EQ(focused(), 0u);
  EXPECT_FALSE(state.document.selection.primitives.empty());
  press(kEscape);
  EXPECT_TRUE(state.document.selection.primitives.empty());
}

TEST_F(KeyboardFocus, ArrowsMoveBetweenControls) {
  focus("toolstrip/rotate");
  press(GLFW_KEY_DOWN);
  EXPECT_EQ(focusedId(), "toolstrip/scale");
  press(GLFW_KEY_UP);
  EXPECT_EQ(focusedId(), "toolstrip/rotate");
}

TEST_F(KeyboardFocus, ShortcutsWorkWithoutKeyboardFocus) {
  press(kSpace);
  EXPECT_TRUE(state.open.transport.playing);
  press(kSpace);
  const double time = state.open.transport.time;
  press(GLFW_KEY_RIGHT);
  EXPECT_EQ(focused(), 0u);
  EXPECT_NE(state.open.transport.time, time);
  tab();
  ASSERT_NE(focused(), 0u);
  clickAt({640.0f, 300.0f});
  EXPECT_EQ(focused(), 0u) << "the ring stays though the mouse is used";
}

TEST_F(KeyboardFocus, DialogKeepsTheFocus) {
  run(action("file/preferences"), state);
  settle();
  std::set<std::string> reached;
  for (int i = 0; i < 40; ++i) {
    tab();
    reached.insert(focusedId());
  }
  for (const std::string& id : reached) EXPECT_TRUE(id.starts_with("preferences/")) << id;
  for (const char* id : {"preferences/keymap/blender", "preferences/scale", "preferences/moving/full",
                         "preferences/autosave", "preferences/forget", "preferences/close"}) {
    EXPECT_TRUE(reached.contains(id)) << id;
  }
  press(kEscape);
  EXPECT_FALSE(state.dialogs.preferences);
}

TEST_F(KeyboardFocus, MenuIsOpenedNavigatedAndClosed) {
  focus("menu/view");
  press(kSpace);
  ASSERT_TRUE(shown("view/wire"));
  const bool before = state.view.display.wire;
  for (int i = 0; i < 60 && focusedId() != "view/wire"; ++i) press(GLFW_KEY_DOWN);
  ASSERT_EQ(focusedId(), "view/wire");
  press(kEnter);
  EXPECT_NE(state.view.display.wire, before);
  focus("menu/view");
  press(kSpace);
  ASSERT_TRUE(shown("view/wire"));
  press(kEscape);
  EXPECT_FALSE(shown("view/wire"));
  EXPECT_FALSE(state.document.selection.primitives.empty()) << "Esc has taken two steps";
}

TEST_F(KeyboardFocus, EscapeGoesBackOneStepAtATime) {
  run(action("muscles/body-parts"), state);
  run(action("tool/territory"), state);
  focus("toolstrip/rotate");
  press(kEscape);
  EXPECT_EQ(focused(), 0u);
  EXPECT_TRUE(editsTerritory(state));
  press(kEscape);
  EXPECT_FALSE(editsTerritory(state));
  EXPECT_FALSE(state.document.selection.primitives.empty());
  press(kEscape);
  EXPECT_TRUE(state.document.selection.primitives.empty());
  EXPECT_TRUE(state.open.bodyParts.shown);
  press(kEscape);
  EXPECT_FALSE(state.open.bodyParts.shown);
}

TEST_F(KeyboardFocus, MatrixCellsLinkGroupsFromTheKeyboard) {
  state.view.outliner.tab = LeftTab::kGroups;
  settle();
  run(action("edit/group"), state);
  settle();
  press(kEnter);  // Renames it.
  ASSERT_EQ(state.document.rig().groups.size(), 2u);
  const auto& groups = state.document.rig().groups;
  const std::string cell = "blending/cell/" + groups[1].name + "/" + groups[0].name;
  const std::size_t before = steps();
  focus(cell);
  press(kSpace);
  EXPECT_EQ(steps(), before + 1);
}

}  // namespace
}  // namespace sinew::app
