// tests/editor/actions_test.cpp: the action table is complete and free of conflicts.

#include "app/editor/actions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace sinew::app {
namespace {

const std::set<std::string> kWithoutCharacter{
    "file/open",      "file/preferences",    "file/quit",    "window/left",      "window/right", "window/bottom",
    "window/picture", "window/reset-layout", "help/palette", "help/first-steps", "help/keys"};
constexpr int kKeyZ = 90;
constexpr int kKeyS = 83;
constexpr int kSpace = 32;

TEST(Actions, IdsAreUniqueAndBelongToAMenu) {
  std::set<std::string> ids;
  for (const Action& action : actions()) {
    EXPECT_TRUE(ids.insert(action.id).second) << action.id;
    EXPECT_TRUE(std::ranges::any_of(menus(), [&](const Menu& menu) { return action.menu() == menu.id; })) << action.id;
    EXPECT_EQ(std::ranges::count(std::string(action.id), '/'), 1) << action.id;
  }
}

TEST(Actions, EveryActionHasLabelHintAndHandlers) {
  for (const Action& action : actions()) {
    EXPECT_FALSE(std::string(action.label).empty()) << action.id;
    EXPECT_FALSE(std::string(action.hint).empty()) << action.id;
    EXPECT_NE(action.enabled, nullptr) << action.id;
    EXPECT_NE(action.run, nullptr) << action.id;
  }
}

TEST(Actions, EveryMenuHasEntries) {
  for (const Menu& menu : menus()) {
    EXPECT_TRUE(std::ranges::any_of(actions(), [&](const Action& action) { return action.menu() == menu.id; }))
        << menu.id;
  }
}

TEST(Actions, ActionsThatNeedACharacterDoNotRunWithoutOne) {
  EditorState state;
  for (const Action& action : actions()) {
    const std::string id = action.id;
    const bool needsNone = kWithoutCharacter.contains(id);
    EXPECT_EQ(action.enabled(state), needsNone) << id;
    if (!needsNone) run(action, state);
  }
  EXPECT_FALSE(state.session.quit);
  EXPECT_TRUE(state.session.messages.empty());
}

TEST(Actions, DisabledActionGivesAShortReason) {
  EditorState state;
  for (const Action& action : actions()) {
    const Possible possible = action.enabled(state);
    const std::string why = possible.reason();
    EXPECT_EQ(why.empty(), static_cast<bool>(possible)) << action.id;
    if (possible) continue;
    EXPECT_TRUE(why[0] >= 'A' && why[0] <= 'Z') << action.id << ": " << why;
    EXPECT_NE(why.back(), '.') << action.id;
    EXPECT_LT(why.size(), 60u) << action.id << ": no room for it in the palette";
  }
}

TEST(Actions, FirstReasonWins) {
  EXPECT_TRUE(Possible());
  EXPECT_STREQ(Possible().reason(), "");
  EXPECT_STREQ(Possible(false, "a").also(false, "b").reason(), "a");
  EXPECT_STREQ(Possible(true, "a").also(false, "b").reason(), "b");
  EXPECT_TRUE(Possible(true, "a").also(true, "b"));
}

TEST(Actions, ShortcutOfADisabledActionShowsItsReason) {
  EditorState state;
  RawInput input;
  input.pressedKey = kKeyZ;
  input.control = true;
  EXPECT_TRUE(runShortcut(state, input));
  ASSERT_TRUE(state.session.toast.has_value());
  EXPECT_EQ(state.session.toast->text, "Undo: Open a character first");
}

TEST(Actions, ShortcutsRequireTheirModifiers) {
  EXPECT_EQ(textOf({kKeyZ, true, true}), "Ctrl+Shift+Z");
  EXPECT_EQ(textOf({kSpace, false, false}), "Space");
  EditorState state;
  RawInput input;
  input.pressedKey = kKeyS;
  EXPECT_FALSE(runShortcut(state, input));
  input.control = true;
  EXPECT_TRUE(runShortcut(state, input));
  input.alt = true;
  EXPECT_FALSE(runShortcut(state, input));
}

}  // namespace
}  // namespace sinew::app
