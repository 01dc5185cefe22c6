// tests/panels/nothing_hides_test.cpp: tooltips while the editor sleeps, reasons of disabled controls, messages,
// toasts, and the question about a changed file.

#include <imgui.h>
#include <imgui_internal.h>  // FindWindowByName is internal in ImGui 1.86.

#include <fstream>

#include "app/editor/edit.h"
#include "app/panels/panel_ui.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace sinew::app {
namespace {

class Feedback : public HeadlessEditor {
 protected:
  /// Draws only the frames that are requested, as the idle window does. @return their number
  int sleep(double seconds) {
    int frames = 0;
    for (double slept = 0.0; step.wakeAfter() > 0.0 && slept < seconds && frames < 200; ++frames) {
      slept += step.wakeAfter();
      state.frame.now += step.wakeAfter();
      ImGui::GetIO().DeltaTime = static_cast<float>(step.wakeAfter());
      frame();
    }
    ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
    return frames;
  }
  static bool tooltipSeen() {
    const ImGuiWindow* window = ImGui::FindWindowByName("##Tooltip_00");
    return window != nullptr && window->Active && !window->Hidden;
  }
  [[nodiscard]] std::string hintOfAction(const char* id) {
    WidgetLog log;
    const PanelUi ui(state, log, fonts);
    return hintOf(ui, action(id));
  }
  [[nodiscard]] std::string toast() const { return state.session.toast ? state.session.toast->text : ""; }
};

TEST_F(Feedback, TooltipAppearsWhileTheEditorIsIdle) {
  for (const char* id : {"toolstrip/move", "display/wire", "toolstrip/territory", "timeline/play"}) {
    queue.move({640.0f, 400.0f});
    settle();
    sleep(3.0);
    EXPECT_FALSE(tooltipSeen()) << id;
    queue.move(center(id));
    settle();
    EXPECT_FALSE(tooltipSeen()) << id << ": at once";
    EXPECT_LT(sleep(3.0), 20) << id;
    EXPECT_TRUE(tooltipSeen()) << id;
    EXPECT_EQ(step.wakeAfter(), 0.0) << id << ": keeps the editor awake";
  }
}

TEST_F(Feedback, GrayedMenuEntryHasATooltip) {
  click("menu/edit");
  ASSERT_TRUE(shown("edit/delete"));
  queue.move(center("edit/delete"));
  settle();
  sleep(3.0);
  EXPECT_TRUE(tooltipSeen());
  EXPECT_NE(hintOfAction("edit/delete").find("Select a muscle first"), std::string::npos);
}

TEST_F(Feedback, DisabledReasonMatchesTheState) {
  EXPECT_STREQ(action("edit/delete").enabled(state).reason(), "Select a muscle first");
  EXPECT_STREQ(action("edit/undo").enabled(state).reason(), "Nothing to undo");
  EXPECT_STREQ(action("edit/add-on-bone").enabled(state).reason(), "Select a bone or a muscle first");
  addOne();
  EXPECT_TRUE(action("edit/add-on-bone").enabled(state)) << "on the muscle's bone";
  EXPECT_TRUE(action("edit/delete").enabled(state));
  EXPECT_STREQ(action("edit/link-twins").enabled(state).reason(), "Select two muscles first");
  state.open.gestureItem = 1;
  EXPECT_STREQ(action("edit/delete").enabled(state).reason(), "Finish the current edit first");
  state.open.gestureItem = 0;
  EXPECT_EQ(hintOfAction("edit/delete"), action("edit/delete").hint);
}

TEST_F(Feedback, EnterInThePaletteNeverRunsAGrayedAction) {
  press(GLFW_KEY_P, true);
  type("duplicate");
  ASSERT_TRUE(shown("palette/edit/duplicate"));
  press(kEnter);
  EXPECT_TRUE(state.dialogs.palette.shown) << "nothing was done, and the reason can be read";
  EXPECT_EQ(steps(), 0u);
  press(kEscape);
  addOne();
  press(GLFW_KEY_P, true);
  type("duplicate");
  press(kEnter);
  EXPECT_FALSE(state.dialogs.palette.shown);
  EXPECT_EQ(steps(), 2u);
}

TEST_F(Feedback, NewestMessageIsOnTop) {
  state.session.messages.clear();
  for (int i = 0; i < 30; ++i) addMessage(state.session, MessageKind::kNote, "message " + std::to_string(i));
  settle();
  ASSERT_TRUE(shown("messages/dismiss/29")) << "the newest is out of sight";
  ASSERT_TRUE(shown("messages/dismiss/28"));
  EXPECT_LT(center("messages/dismiss/29").y, center("messages/dismiss/28").y);
  EXPECT_FALSE(shown("messages/dismiss/0"));
  queue.move(center("messages/dismiss/28"));
  queue.scroll({0.0f, -100.0f});
  settle();
  EXPECT_FALSE(shown("messages/dismiss/29"));
  addMessage(state.session, MessageKind::kError, "one more");
  settle();
  EXPECT_TRUE(shown("messages/dismiss/30")) << "scrolled away when it came";
  click("messages/dismiss/30");
  EXPECT_EQ(state.session.messages.back().text, "message 29");
}

TEST_F(Feedback, ToastDisappearsWhileTheEditorSleeps) {
  state.session.messages.clear();
  settle();
  say(state, "Saved arm.rig.json");
  settle();
  ASSERT_TRUE(shown("toast"));
  EXPECT_GT(step.wakeAfter(), 1.0) << "it need not be drawn again while it stays as it is";
  EXPECT_LT(sleep(20.0), 40);
  EXPECT_FALSE(shown("toast"));
  EXPECT_FALSE(state.session.toast.has_value());
  EXPECT_EQ(step.wakeAfter(), 0.0);
}

TEST_F(Feedback, ToastIsNeverUnderThePointer) {
  say(state, "Undone: Move all the muscles of the upper arm");
  settle();
  for (float y = 60.0f; y < 700.0f; y += 40.0f) {
    for (float x = 300.0f; x < 960.0f; x += 60.0f) {
      queue.move({x, y});
      frame();
      frame();
      ASSERT_TRUE(shown("toast"));
      const glm::vec4 box = widgets().rectangles().at("toast");
      const bool over = x >= box.x && x <= box.x + box.z && y >= box.y && y <= box.y + box.w;
      EXPECT_FALSE(over) << x << ", " << y;
    }
  }
}

TEST_F(Feedback, RefusalDoesNotChangeTheStatusLine) {
  const std::string before = state.frame.route.status;
  refuse(state, errorAt("primitives[0].radii[1]", "expected a number > 0, got -1", "radius Y"));
  settle();
  EXPECT_EQ(state.frame.route.status, before);
  EXPECT_EQ(toast(), "Radius Y: expected a number > 0, got -1");
}

TEST_F(Feedback, PasteReportsACount) {
  addOne();
  press(GLFW_KEY_C, true);
  press(GLFW_KEY_V, true);
  EXPECT_EQ(toast().substr(0, 7), "Pasted ") << toast();
}

TEST_F(Feedback, DuplicateMessageNamesTheCopyAndItsPosition) {
  addOne();
  const std::string original = state.document.activeName();
  duplicateSelection(state);
  const std::string copy = state.document.activeName();
  EXPECT_NE(copy, original);
  EXPECT_NE(toast().find(copy), std::string::npos) << toast();
  EXPECT_NE(toast().find("exactly on the original"), std::string::npos) << toast();
  EXPECT_FALSE(ownsKeyboard(state.view.tools)) << "in this keymap it stays where it is";
  press(GLFW_KEY_C, true);
  press(GLFW_KEY_V, true);
  EXPECT_NE(toast().find("exactly on "), std::string::npos) << toast();
}

TEST_F(Feedback, BlenderKeymapDuplicateFollowsThePointerAndEscapeRestoresItsPosition) {
  state.session.preferences.keymap = Keymap::kBlender;
  addOne();
  const Placement start = muscle().placement;
  queue.move({640.0f, 400.0f});
  settle();
  duplicateSelection(state);
  const std::size_t made = steps();
  settle();
  queue.move({700.0f, 380.0f});
  settle();
  const auto copy = [&] { return state.document.rig().primitives.back().placement; };
  EXPECT_NE(copy().center, start.center);
  press(kEscape);
  EXPECT_EQ(copy().center, start.center);
  EXPECT_EQ(steps(), made) << "the copy stays";
  EXPECT_EQ(muscle().placement, start);
}

TEST_F(Feedback, ToastDoesNotCoverADialog) {
  showSaveDialog(state, {});
  settle();
  say(state, "Saved somewhere");
  settle();
  ASSERT_TRUE(shown("toast"));
  const ImGuiWindow* dialog = ImGui::GetTopMostPopupModal();
  ASSERT_NE(dialog, nullptr);
  const glm::vec4 box = widgets().rectangles().at("toast");
  EXPECT_FALSE(dialog->Rect().Overlaps(ImRect(box.x, box.y, box.x + box.z, box.y + box.w)));
  EXPECT_GE(box.y, 0.0f);
  EXPECT_LE(box.y + box.w, ImGui::GetIO().DisplaySize.y);
}

class ConflictDialog : public Feedback {
 protected:
  void SetUp() override {
    Feedback::SetUp();
    addOne();
    ASSERT_EQ(saveTo(state, rig), "");
    std::ofstream(rig, std::ios::app) << "\n";
    addMuscle(state, 1);
    settle();
  }
  const test::TemporaryFolder own;
  const std::filesystem::path rig = own.path() / "arm.rig.json";
};

TEST_F(ConflictDialog, CtrlSOpensItAndEscapeChangesNothing) {
  press(GLFW_KEY_S, true);
  for (const char* id : {"conflict/both", "conflict/reload", "conflict/overwrite", "conflict/cancel"})
    EXPECT_TRUE(shown(id)) << id;
  press(kEscape);
  EXPECT_FALSE(shown("conflict/both"));
  EXPECT_TRUE(state.document.commands.modified());
}

TEST_F(ConflictDialog, EachChoiceIsAButton) {
  press(GLFW_KEY_S, true);
  click("conflict/both");
  EXPECT_EQ(state.document.rigFile.filename(), "arm 2.rig.json");
  EXPECT_FALSE(state.document.commands.modified());
  std::filesystem::remove(state.document.rigFile);
  addMuscle(state, 1);
  press(GLFW_KEY_S, true);
  EXPECT_FALSE(shown("conflict/reload")) << "there is nothing to load";
  click("conflict/overwrite");
  EXPECT_TRUE(std::filesystem::exists(state.document.rigFile));
  EXPECT_EQ(state.dialogs.conflict.found, OnDisk::kSame);
}

}  // namespace
}  // namespace sinew::app
