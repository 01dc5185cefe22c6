// tests/editor/bindings_test.cpp: rebound keys: a key runs at most one action after any sequence of changes.

#include "app/editor/bindings.h"

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <string>

namespace sinew::app {
namespace {

using Keys = std::array<Shortcut, 2>;

/// Every key of every action, by its text.
std::map<std::string, std::vector<std::string>> owners(const Preferences& preferences) {
  std::map<std::string, std::vector<std::string>> all;
  for (const Action& item : actions()) {
    for (const Shortcut& shortcut : shortcutsOf(item, preferences)) {
      if (shortcut.key != 0) all[textOf(shortcut)].push_back(item.id);
    }
  }
  return all;
}

void expectSound(const Preferences& preferences, const std::string& after) {
  for (const auto& [key, ids] : owners(preferences)) {
    ASSERT_EQ(ids.size(), 1u) << key << " is the key of " << ids.front() << " and " << ids.back() << after;
  }
  for (const Action& item : actions()) {
    const Keys keys = shortcutsOf(item, preferences);
    ASSERT_TRUE(keys[0].key != 0 || keys[1].key == 0) << item.id << after;
    ASSERT_EQ(isRebound(item, preferences), keys != shortcutsOf(item, preferences.keymap)) << item.id << after;
  }
}

/// Random user of the page.
class Hand {
 public:
  explicit Hand(unsigned seed) : random_(seed) {}
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  const Action& anyAction() { return actions()[static_cast<std::size_t>(below(static_cast<int>(actions().size())))]; }
  Shortcut anyKey() {
    // Few letters and modifiers, so that keys are often taken; some are reserved or have no name.
    constexpr std::array kKeys{GLFW_KEY_W,    GLFW_KEY_D,     GLFW_KEY_A,         GLFW_KEY_X,      GLFW_KEY_M,
                               GLFW_KEY_HOME, GLFW_KEY_ENTER, GLFW_KEY_ESCAPE,    GLFW_KEY_DELETE, GLFW_KEY_KP_ADD,
                               GLFW_KEY_F20,  GLFW_KEY_SPACE, GLFW_KEY_LEFT_SHIFT};
    const int key = kKeys[static_cast<std::size_t>(below(static_cast<int>(kKeys.size())))];
    return {key, below(3) == 0, below(3) == 0, below(4) == 0};
  }
  std::string act(EditorState& state) {
    const Action& item = anyAction();
    switch (below(8)) {
      case 0:
        requestKeyReset(state, item);
        return std::string("reset ") + item.id;
      case 1:
        replaceKeys(state);
        return "replace";
      case 2:
        if (below(20) == 0) resetAllKeys(state.session.preferences);
        return "perhaps reset all";
      case 3:
        state.session.preferences.keymap = kKeymaps[static_cast<std::size_t>(below(2))];
        endKeyCapture(state);
        return "keymap";
      default:
        startKeyCapture(state, item, below(2));
        const Shortcut pressed = anyKey();
        captureKey(state, pressed);
        if (below(2) == 0) replaceKeys(state);
        return std::string(item.id) + " " + textOf(pressed);
    }
  }

 private:
  std::mt19937 random_;
};

class RandomBindings : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Seeds, RandomBindings, testing::Range(1u, 13u));

TEST_P(RandomBindings, KeysStayUniqueAndSurviveAFileRoundTrip) {
  Hand hand(GetParam());
  EditorState state;
  const Preferences& preferences = state.session.preferences;
  std::size_t most = 0;
  for (int step = 0; step < 400; ++step) {
    const std::string done = hand.act(state);
    ASSERT_NO_FATAL_FAILURE(expectSound(preferences, " after " + done));
    most = std::max(most, preferences.keyChanges().size());
    if (step % 20 != 0) continue;
    Preferences read = preferencesFromJson(preferencesToJson(preferences)).value();
    EXPECT_EQ(read, preferences) << done;
    EXPECT_TRUE(dropUnusableKeys(read).empty()) << done;
    EXPECT_EQ(read, preferences) << "what the program wrote is all usable, after " << done;
  }
  EXPECT_GT(most, 8u) << "the hand changed too little to show anything";
}

TEST_P(RandomBindings, EveryKeyRunsItsDisplayedAction) {
  Hand hand(GetParam());
  EditorState state;
  for (int step = 0; step < 150; ++step) hand.act(state);
  for (const Action& item : actions()) {
    for (const Shortcut& shortcut : shortcutsOf(item, state.session.preferences)) {
      if (shortcut.key != 0) {
        EXPECT_EQ(ownerOf(shortcut, state.session.preferences), &item) << textOf(shortcut);
      }
    }
  }
}

TEST_P(RandomBindings, ArbitraryFileGivesValidKeys) {
  Hand hand(GetParam());
  for (int file = 0; file < 30; ++file) {
    Preferences preferences;
    preferences.keymap = kKeymaps[static_cast<std::size_t>(hand.below(2))];
    for (int entry = 0; entry < 12; ++entry) {
      const std::string id = hand.below(6) == 0 ? "edit/no-such" : hand.anyAction().id;
      std::vector<std::string>& texts = preferences.keyChanges()[id];
      for (int i = hand.below(4); i > 0; --i) {
        texts.push_back(hand.below(6) == 0 ? "Strg+?" : textOf(hand.anyKey()));
      }
    }
    std::ignore = dropUnusableKeys(preferences);
    ASSERT_NO_FATAL_FAILURE(expectSound(preferences, ""));
    EXPECT_TRUE(dropUnusableKeys(preferences).empty()) << "once is enough";
  }
}

TEST(Bindings, KeyTextRoundTrips) {
  std::set<std::string> texts;
  for (int key = 1; key <= GLFW_KEY_LAST; ++key) {
    for (int modifiers = 0; modifiers < 8; ++modifiers) {
      const Shortcut shortcut{key, (modifiers & 1) != 0, (modifiers & 2) != 0, (modifiers & 4) != 0};
      if (!whyReserved(shortcut).empty()) continue;
      const std::string text = textOf(shortcut);
      EXPECT_TRUE(texts.insert(text).second) << text << " is two keys";
      EXPECT_EQ(shortcutFrom(text), shortcut) << text;
    }
  }
  EXPECT_GT(texts.size(), 8u * 60u);
  for (const char* text : {"", "Ctrl+", "Ctrl", "Shift+Ctrl+Z", "ctrl+z", "Ctrl+ZZ", "Hyper+Z", " Z", "?"}) {
    EXPECT_FALSE(shortcutFrom(text)) << text;
  }
}

TEST(Bindings, EscEnterModifiersAndNamelessKeysAreReserved) {
  for (const int key : {GLFW_KEY_ESCAPE, GLFW_KEY_ENTER, GLFW_KEY_KP_ENTER, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_CONTROL,
                        GLFW_KEY_LEFT_ALT, GLFW_KEY_LEFT_SUPER, GLFW_KEY_CAPS_LOCK, GLFW_KEY_PRINT_SCREEN, GLFW_KEY_F20,
                        GLFW_KEY_WORLD_1}) {
    EXPECT_NE(whyReserved({key}), "") << key;
    EXPECT_NE(whyReserved({key, true, true, true}), "") << key;
  }
  EXPECT_EQ(whyReserved({GLFW_KEY_TAB}), "");
  EXPECT_EQ(whyReserved({GLFW_KEY_K, true, true, true}), "");
}

TEST(Bindings, TakenKeyPromptsAndCancelChangesNothing) {
  EditorState state;
  const Preferences before = state.session.preferences;
  startKeyCapture(state, action("view/ground"), 0);
  captureKey(state, {GLFW_KEY_W});
  EXPECT_EQ(state.dialogs.keyCapture.step, KeyCapture::Step::kAsking);
  EXPECT_NE(state.dialogs.keyCapture.notice.find(action("tool/move").label), std::string::npos);
  endKeyCapture(state);
  replaceKeys(state);
  EXPECT_EQ(state.session.preferences, before);
}

TEST(Bindings, ReplaceTakesTheKeyAndResetPromptsToRestoreIt) {
  EditorState state;
  Preferences& preferences = state.session.preferences;
  startKeyCapture(state, action("view/ground"), 0);
  captureKey(state, {GLFW_KEY_W});
  replaceKeys(state);
  EXPECT_EQ(ownerOf({GLFW_KEY_W}, preferences), &action("view/ground"));
  EXPECT_EQ(ownerOf({GLFW_KEY_0}, preferences), nullptr);
  EXPECT_EQ(keyText(action("tool/move"), state), "");
  requestKeyReset(state, action("tool/move"));
  EXPECT_EQ(state.dialogs.keyCapture.step, KeyCapture::Step::kAsking);
  EXPECT_EQ(ownerOf({GLFW_KEY_W}, preferences), &action("view/ground")) << "not before the answer";
  replaceKeys(state);
  EXPECT_EQ(ownerOf({GLFW_KEY_W}, preferences), &action("tool/move"));
  EXPECT_EQ(keyText(action("view/ground"), state), "");
  resetAllKeys(preferences);
  EXPECT_EQ(preferences, Preferences{});
}

TEST(Bindings, ReservedKeyIsRefusedAndCaptureContinues) {
  EditorState state;
  startKeyCapture(state, action("view/ground"), 1);
  captureKey(state, {GLFW_KEY_ENTER});
  EXPECT_EQ(state.dialogs.keyCapture.step, KeyCapture::Step::kWaiting);
  EXPECT_NE(state.dialogs.keyCapture.notice, "");
  captureKey(state, {GLFW_KEY_J});
  EXPECT_EQ(state.dialogs.keyCapture.step, KeyCapture::Step::kNone);
  const Keys keys = shortcutsOf(action("view/ground"), state.session.preferences);
  EXPECT_EQ(keys[0], (Shortcut{GLFW_KEY_0}));
  EXPECT_EQ(keys[1], (Shortcut{GLFW_KEY_J}));
}

TEST(Bindings, BackspaceAndDeleteClearAndEscapeCancels) {
  for (const int key : {GLFW_KEY_BACKSPACE, GLFW_KEY_DELETE}) {
    EditorState state;
    startKeyCapture(state, action("view/frame-all"), 0);
    captureKey(state, {key});
    EXPECT_EQ(keyText(action("view/frame-all"), state), "Home") << "the second moves up";
  }
  EditorState state;
  startKeyCapture(state, action("view/frame-all"), 0);
  captureKey(state, {GLFW_KEY_ESCAPE});
  EXPECT_EQ(state.dialogs.keyCapture.step, KeyCapture::Step::kNone);
  EXPECT_EQ(state.session.preferences, Preferences{});
}

TEST(Bindings, EachKeymapHasItsOwnChanges) {
  Preferences preferences;
  giveKey(preferences, action("view/ground"), 0, {GLFW_KEY_J});
  preferences.keymap = Keymap::kBlender;
  EXPECT_EQ(ownerOf({GLFW_KEY_J}, preferences), nullptr);
  giveKey(preferences, action("view/wire"), 0, {GLFW_KEY_J});
  preferences.keymap = Keymap::kMaya;
  EXPECT_EQ(ownerOf({GLFW_KEY_J}, preferences), &action("view/ground"));
}

TEST(Bindings, UnusableEntriesOfAFileAreDroppedWithNotes) {
  Preferences preferences = preferencesFromJson(R"({"format": "sinew-preferences", "keys": {"maya": {
      "edit/gone": ["K"], "view/ground": ["Hyper+K"], "view/wire": ["Enter"], "view/skeleton": ["K", 7],
      "view/primitives": ["K"], "view/clay": [], "edit/undo": "K",
      "view/influence": ["W"], "edit/select-none": ["J", "Esc"]}}})")
                                .value();
  const std::vector<std::string> notes = dropUnusableKeys(preferences);
  EXPECT_EQ(notes.size(), 5u);
  for (const char* part : {"edit/gone", "Hyper+K", "Enter", "used twice", "\"?\""}) {
    EXPECT_TRUE(std::ranges::any_of(notes, [&](const std::string& n) { return n.find(part) != n.npos; })) << part;
  }
  EXPECT_EQ(ownerOf({GLFW_KEY_0}, preferences), &action("view/ground"));
  EXPECT_EQ(ownerOf({GLFW_KEY_K}, preferences), &action("view/primitives")) << "in the order of the ids";
  EXPECT_EQ(ownerOf({GLFW_KEY_2}, preferences), nullptr) << "an empty list is a wish";
  EXPECT_EQ(ownerOf({GLFW_KEY_W}, preferences), &action("view/influence")) << "the user's key before the keymap's";
  EXPECT_EQ(ownerOf({GLFW_KEY_ESCAPE}, preferences), &action("edit/select-none")) << "its own key is not reserved";
  EXPECT_EQ(ownerOf({GLFW_KEY_Z, true}, preferences), &action("edit/undo"));
  expectSound(preferences, "");
}

}  // namespace
}  // namespace sinew::app
