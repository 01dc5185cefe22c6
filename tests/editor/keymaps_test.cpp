// tests/editor/keymaps_test.cpp: a key has one meaning in every keymap, and the presets keep their promises.

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "app/editor/actions.h"
#include "app/ui/window.h"

namespace sinew::app {
namespace {

constexpr std::array kKeymaps{Keymap::kMaya, Keymap::kBlender};

class EveryKeymap : public testing::TestWithParam<Keymap> {};
INSTANTIATE_TEST_SUITE_P(All, EveryKeymap, testing::ValuesIn(kKeymaps),
                         [](const auto& tested) { return std::string(nameOf(tested.param)); });

TEST_P(EveryKeymap, NoTwoActionsShareAKey) {
  std::map<std::string, std::string> owners;
  for (const Action& action : actions()) {
    for (const Shortcut& shortcut : shortcutsOf(action, GetParam())) {
      if (shortcut.key == 0) continue;
      const auto [owner, fresh] = owners.emplace(textOf(shortcut), action.id);
      EXPECT_TRUE(fresh) << textOf(shortcut) << ": " << owner->second << " and " << action.id;
    }
  }
}

TEST_P(EveryKeymap, KeysHavePrintableNames) {
  for (const Action& action : actions()) {
    for (const Shortcut& shortcut : shortcutsOf(action, GetParam())) {
      const std::string text = textOf(shortcut);
      EXPECT_TRUE(std::ranges::all_of(text, [](char c) { return c >= 32 && c < 127; })) << action.id;
      EXPECT_EQ(shortcut.key == 0, text.empty()) << action.id;
    }
  }
}

TEST_P(EveryKeymap, ChangesNameExistingActionsOnce) {
  std::set<std::string> changed;
  for (const KeyChange& change : changesOf(GetParam())) {
    EXPECT_TRUE(changed.insert(change.id).second) << change.id;
    EXPECT_TRUE(std::ranges::any_of(actions(), [&](const Action& a) { return std::string(a.id) == change.id; }))
        << change.id;
  }
}

TEST_P(EveryKeymap, SecondKeyRequiresAFirst) {
  for (const Action& action : actions()) {
    const auto keys = shortcutsOf(action, GetParam());
    EXPECT_TRUE(keys[0].key != 0 || keys[1].key == 0) << action.id;
  }
}

/// Meaning found by pressing the key, as a user would.
std::string meaningOf(const Shortcut& shortcut, Keymap keymap) {
  for (const Action& action : actions()) {
    const auto keys = shortcutsOf(action, keymap);
    if (std::ranges::find(keys, shortcut) != keys.end()) return action.id;
  }
  return "";
}

TEST(Keymaps, MayaHasToolsOnQWER) {
  const auto plain = [](int key) { return meaningOf({key, false, false, false}, Keymap::kMaya); };
  EXPECT_EQ(plain(GLFW_KEY_Q), "tool/select");
  EXPECT_EQ(plain(GLFW_KEY_W), "tool/move");
  EXPECT_EQ(plain(GLFW_KEY_E), "tool/rotate");
  EXPECT_EQ(plain(GLFW_KEY_R), "tool/scale");
  EXPECT_EQ(plain(GLFW_KEY_F), "view/frame");
  EXPECT_EQ(plain(GLFW_KEY_A), "view/frame-all");
  EXPECT_EQ(plain(GLFW_KEY_DELETE), "edit/delete");
  EXPECT_EQ(meaningOf({GLFW_KEY_D, true, false, false}, Keymap::kMaya), "edit/duplicate");
}

TEST(Keymaps, BlenderHasGrabRotateAndScaleOnGRS) {
  const auto plain = [](int key) { return meaningOf({key, false, false, false}, Keymap::kBlender); };
  EXPECT_EQ(plain(GLFW_KEY_G), "tool/grab");
  EXPECT_EQ(plain(GLFW_KEY_R), "tool/turn");
  EXPECT_EQ(plain(GLFW_KEY_S), "tool/size");
  EXPECT_EQ(plain(GLFW_KEY_X), "edit/delete");
  EXPECT_EQ(plain(GLFW_KEY_DELETE), "edit/delete");
  EXPECT_EQ(plain(GLFW_KEY_KP_1), "view/front");
  EXPECT_EQ(plain(GLFW_KEY_KP_DECIMAL), "view/frame");
  EXPECT_EQ(plain(GLFW_KEY_HOME), "view/frame-all");
  EXPECT_EQ(meaningOf({GLFW_KEY_D, false, true, false}, Keymap::kBlender), "edit/duplicate");
  EXPECT_EQ(meaningOf({GLFW_KEY_A, false, true, false}, Keymap::kBlender), "tool/add-muscle");
  EXPECT_EQ(meaningOf({GLFW_KEY_A, false, false, true}, Keymap::kBlender), "edit/select-none");
}

TEST(Keymaps, CommonShortcutsAreTheSameInBoth) {
  for (const Keymap keymap : kKeymaps) {
    EXPECT_EQ(meaningOf({GLFW_KEY_P, true, false, false}, keymap), "help/palette");
    EXPECT_EQ(meaningOf({GLFW_KEY_F1, false, false, false}, keymap), "help/keys");
    EXPECT_EQ(meaningOf({GLFW_KEY_S, true, false, false}, keymap), "file/save");
    EXPECT_EQ(meaningOf({GLFW_KEY_O, true, false, false}, keymap), "file/open");
    EXPECT_EQ(meaningOf({GLFW_KEY_Z, true, false, false}, keymap), "edit/undo");
  }
}

TEST(Keymaps, ActiveKeymapDecidesWhatAKeyDoes) {
  EditorState state;
  RawInput input;
  input.pressedKey = GLFW_KEY_F3;
  EXPECT_FALSE(runShortcut(state, input));
  state.session.preferences.keymap = Keymap::kBlender;
  EXPECT_TRUE(runShortcut(state, input));
  EXPECT_TRUE(state.dialogs.palette.shown);
}

TEST(Keymaps, ExtraModifiersDoNotMatch) {
  EditorState state;
  RawInput input;
  input.pressedKey = GLFW_KEY_F1;
  input.alt = true;
  EXPECT_FALSE(runShortcut(state, input));
  input.alt = false;
  EXPECT_TRUE(runShortcut(state, input));
  EXPECT_TRUE(state.dialogs.keySheet);
}

TEST(KeyMeaning, LettersAndPunctuationFollowTheLayout) {
  EXPECT_EQ(keyMeaning(GLFW_KEY_Q, "a"), GLFW_KEY_A);          // AZERTY
  EXPECT_EQ(keyMeaning(GLFW_KEY_SEMICOLON, "m"), GLFW_KEY_M);  // AZERTY
  EXPECT_EQ(keyMeaning(GLFW_KEY_M, ","), GLFW_KEY_COMMA);      // AZERTY
  EXPECT_EQ(keyMeaning(GLFW_KEY_Y, "z"), GLFW_KEY_Z);          // QWERTZ
  EXPECT_EQ(keyMeaning(GLFW_KEY_A, "A"), GLFW_KEY_A);
}

TEST(KeyMeaning, DigitsFunctionKeysAndOtherScriptsFollowThePhysicalKey) {
  EXPECT_EQ(keyMeaning(GLFW_KEY_1, "&"), GLFW_KEY_1);         // AZERTY: digits with Shift only.
  EXPECT_EQ(keyMeaning(GLFW_KEY_6, "-"), GLFW_KEY_6);         // AZERTY
  EXPECT_EQ(keyMeaning(GLFW_KEY_Q, "\xd0\xb9"), GLFW_KEY_Q);  // Cyrillic
  EXPECT_EQ(keyMeaning(GLFW_KEY_Q, nullptr), GLFW_KEY_Q);
  EXPECT_EQ(keyMeaning(GLFW_KEY_F1, nullptr), GLFW_KEY_F1);
  EXPECT_EQ(keyMeaning(GLFW_KEY_KP_1, "1"), GLFW_KEY_KP_1);
  EXPECT_EQ(keyMeaning(GLFW_KEY_SPACE, " "), GLFW_KEY_SPACE);
  EXPECT_EQ(keyMeaning(GLFW_KEY_MINUS, "\xc3\x9f"), GLFW_KEY_MINUS);  // QWERTZ: a letter of two bytes.
  EXPECT_EQ(keyMeaning(GLFW_KEY_Q, ""), GLFW_KEY_Q);
}

}  // namespace
}  // namespace sinew::app
