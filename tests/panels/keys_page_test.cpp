// tests/panels/keys_page_test.cpp: the preferences page that rebinds keys.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/editor/bindings.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

class KeysPage : public HeadlessEditor {
 protected:
  void openPage() {
    press(GLFW_KEY_COMMA, true);
    click("preferences/page/keys");
    ASSERT_TRUE(shown("preferences/keys/search"));
  }
  /// Filters to one row and clicks its first key.
  void clickKey(const std::string& id, const std::string& slot = "1") {
    state.dialogs.keySearch = action(id).label;
    settle();
    click("preferences/keys/" + id + "/" + slot);
  }
  [[nodiscard]] std::string keyOf(const std::string& id) const { return keyText(action(id), state); }
  [[nodiscard]] KeyCapture::Step captureStep() const { return state.dialogs.keyCapture.step; }
};

TEST_F(KeysPage, ChangedKeyWorksImmediately) {
  openPage();
  clickKey("view/ground");
  press(GLFW_KEY_K, true);
  EXPECT_EQ(keyOf("view/ground"), "Ctrl+K");
  press(kEscape);
  ASSERT_FALSE(state.dialogs.preferences);
  const bool ground = state.view.display.ground;
  press(GLFW_KEY_0);
  EXPECT_EQ(state.view.display.ground, ground) << "the old key does nothing";
  press(GLFW_KEY_K, true);
  EXPECT_NE(state.view.display.ground, ground);
}

TEST_F(KeysPage, CapturingAKeySuppressesAllShortcuts) {
  openPage();
  clickKey("view/ground");
  press(kEscape);
  EXPECT_TRUE(state.dialogs.preferences) << "Esc gives up the key, not the window";
  EXPECT_EQ(captureStep(), KeyCapture::Step::kNone);
  clickKey("view/ground", "2");
  press(GLFW_KEY_P, true);
  EXPECT_FALSE(state.dialogs.palette.shown);
  EXPECT_TRUE(shown("preferences/keys/replace"));
  press(kEscape);
  EXPECT_TRUE(state.dialogs.preferences);
  EXPECT_FALSE(shown("preferences/keys/replace"));
  EXPECT_EQ(keyOf("help/palette"), "Ctrl+P");
}

TEST_F(KeysPage, ModifierAloneIsRefusedButAcceptedInACombination) {
  openPage();
  clickKey("view/ground");
  queue.key(kLeftControl, true);
  settle();
  EXPECT_EQ(state.dialogs.keyCapture.notice, "") << "it may be the start of Ctrl+J";
  queue.key(kLeftControl, false);
  settle();
  EXPECT_EQ(captureStep(), KeyCapture::Step::kWaiting);
  EXPECT_NE(state.dialogs.keyCapture.notice, "");
  press(GLFW_KEY_J, true);
  EXPECT_EQ(keyOf("view/ground"), "Ctrl+J");
}

TEST_F(KeysPage, ReplaceResetAndResetAllWork) {
  openPage();
  clickKey("view/ground");
  press(GLFW_KEY_W);
  click("preferences/keys/replace");
  EXPECT_EQ(keyOf("view/ground"), "W");
  EXPECT_EQ(keyOf("tool/move"), "");
  click("preferences/keys/view/ground/reset");
  EXPECT_EQ(keyOf("view/ground"), "0");
  EXPECT_EQ(keyOf("tool/move"), "") << "a key that was taken does not come back by itself";
  click("preferences/keys/reset-all");
  EXPECT_EQ(keyOf("tool/move"), "W");
  EXPECT_TRUE(state.session.preferences.keyChanges().empty());
}

TEST_F(KeysPage, SearchFindsActionsByKey) {
  openPage();
  EXPECT_TRUE(shown("preferences/keys/file/open/1"));
  click("preferences/keys/search");
  type("ctrl+shift+z");
  EXPECT_TRUE(shown("preferences/keys/edit/redo/1"));
  EXPECT_FALSE(shown("preferences/keys/file/open/1"));
}

TEST_F(KeysPage, EveryActionHasARow) {
  openPage();
  for (const Action& item : actions()) {
    state.dialogs.keySearch = item.label;
    settle();
    EXPECT_TRUE(shown("preferences/keys/" + std::string(item.id) + "/2")) << item.id;
  }
}

TEST_F(KeysPage, KeySheetClosesWithTheKeyThatOpensIt) {
  giveKey(state.session.preferences, action("help/keys"), 0, {GLFW_KEY_J, true, false, false});
  press(GLFW_KEY_J, true);
  ASSERT_TRUE(state.dialogs.keySheet);
  press(GLFW_KEY_F1);
  EXPECT_TRUE(state.dialogs.keySheet);
  press(GLFW_KEY_J, true);
  EXPECT_FALSE(state.dialogs.keySheet);
}

TEST_F(KeysPage, HeldActionFollowsItsAssignedKey) {
  addOne();
  giveKey(state.session.preferences, action("view/before"), 0, {GLFW_KEY_J, false, false, false});
  queue.key(GLFW_KEY_J, true);
  settle();
  EXPECT_TRUE(state.document.visibility.bare);
  queue.key(GLFW_KEY_LEFT_SHIFT, true);
  settle();
  EXPECT_TRUE(state.document.visibility.bare) << "Shift+drag pans meanwhile";
  queue.key(GLFW_KEY_J, false);
  settle();
  EXPECT_FALSE(state.document.visibility.bare);
}

}  // namespace
}  // namespace sinew::app
