// app/editor/actions.cpp: finding and running actions; keymaps. The table is in action_table*.cpp.
#include "app/editor/actions.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "app/editor/action_table.h"
#include "app/editor/bindings.h"
#include "app/editor/edit.h"

namespace sinew::app {
namespace {

struct KeyName {
  int key;
  const char* name;
};

constexpr std::array kKeyNames{
    KeyName{GLFW_KEY_SPACE, "Space"},
    KeyName{GLFW_KEY_DELETE, "Del"},
    KeyName{GLFW_KEY_ESCAPE, "Esc"},
    KeyName{GLFW_KEY_LEFT, "Left"},
    KeyName{GLFW_KEY_RIGHT, "Right"},
    KeyName{GLFW_KEY_HOME, "Home"},
    KeyName{GLFW_KEY_END, "End"},
    KeyName{GLFW_KEY_COMMA, ","},
    KeyName{GLFW_KEY_PERIOD, "."},
    KeyName{GLFW_KEY_KP_0, "Num 0"},
    KeyName{GLFW_KEY_KP_1, "Num 1"},
    KeyName{GLFW_KEY_KP_3, "Num 3"},
    KeyName{GLFW_KEY_KP_5, "Num 5"},
    KeyName{GLFW_KEY_KP_7, "Num 7"},
    KeyName{GLFW_KEY_BACKSPACE, "Backspace"},
    KeyName{GLFW_KEY_UP, "Up"},
    KeyName{GLFW_KEY_DOWN, "Down"},
    KeyName{GLFW_KEY_KP_DECIMAL, "Num ."},
    KeyName{GLFW_KEY_TAB, "Tab"},
    KeyName{GLFW_KEY_ENTER, "Enter"},
    KeyName{GLFW_KEY_KP_DIVIDE, "Num /"},
    KeyName{GLFW_KEY_KP_2, "Num 2"},
    KeyName{GLFW_KEY_KP_4, "Num 4"},
    KeyName{GLFW_KEY_KP_6, "Num 6"},
    KeyName{GLFW_KEY_KP_8, "Num 8"},
    KeyName{GLFW_KEY_KP_9, "Num 9"},
    KeyName{GLFW_KEY_PAGE_UP, "Page up"},
    KeyName{GLFW_KEY_PAGE_DOWN, "Page down"},
    KeyName{GLFW_KEY_INSERT, "Ins"},
    KeyName{GLFW_KEY_KP_ADD, "Num +"},
    KeyName{GLFW_KEY_KP_SUBTRACT, "Num -"},
    KeyName{GLFW_KEY_KP_MULTIPLY, "Num *"},
    KeyName{GLFW_KEY_KP_ENTER, "Num Enter"},
    KeyName{GLFW_KEY_PAUSE, "Pause"},
};

std::string nameOfKey(int key) {
  if (const auto found = std::ranges::find(kKeyNames, key, &KeyName::key); found != kKeyNames.end()) return found->name;
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  // GLFW's codes of these keys are their ASCII characters.
  constexpr std::string_view kPrinted = "',-./0123456789;=ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]`";
  const bool printed = key > 0 && key < 128 && kPrinted.find(static_cast<char>(key)) != std::string_view::npos;
  return printed ? std::string(1, static_cast<char>(key)) : "";
}

/// 0: none.
int keyNamed(std::string_view name) {
  for (int key = GLFW_KEY_SPACE; !name.empty() && key <= GLFW_KEY_LAST; ++key) {
    if (nameOfKey(key) == name) return key;
  }
  return 0;
}

bool takePrefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

bool repeats(const Action& action) {
  constexpr std::array<std::string_view, 4> kRepeated{"edit/undo", "edit/redo", "play/next", "play/previous"};
  return std::ranges::find(kRepeated, action.id) != kRepeated.end();
}

}  // namespace

const Action& action(std::string_view id) {
  const auto found = std::ranges::find(actions(), id, [](const Action& a) { return std::string_view(a.id); });
  assert(found != actions().end());
  return *found;
}

std::array<Shortcut, 2> shortcutsOf(const Action& action, Keymap keymap) {
  for (const KeyChange& change : changesOf(keymap)) {
    if (std::string_view(change.id) == action.id) return {change.shortcut, change.second};
  }
  return {action.shortcut, action.second};
}

std::array<Shortcut, 2> shortcutsOf(const Action& action, const Preferences& preferences) {
  const auto changed = preferences.keyChanges().find(action.id);
  if (changed == preferences.keyChanges().end()) return shortcutsOf(action, preferences.keymap);
  std::array<Shortcut, 2> keys{};
  for (std::size_t i = 0; i < std::min(keys.size(), changed->second.size()); ++i) {
    keys[i] = shortcutFrom(changed->second[i]).value_or(Shortcut{});
  }
  return keys;
}

std::optional<Shortcut> shortcutFrom(std::string_view text) {
  Shortcut shortcut;
  shortcut.control = takePrefix(text, "Ctrl+");
  shortcut.alt = takePrefix(text, "Alt+");
  shortcut.shift = takePrefix(text, "Shift+");
  shortcut.key = keyNamed(text);
  return shortcut.key != 0 ? std::optional(shortcut) : std::nullopt;
}

std::string textOf(const Shortcut& shortcut) {
  if (shortcut.key == 0) return "";
  std::string text;
  if (shortcut.control) text += "Ctrl+";
  if (shortcut.alt) text += "Alt+";
  if (shortcut.shift) text += "Shift+";
  return text + nameOfKey(shortcut.key);
}

std::string keyText(const Action& action, const EditorState& state) {
  return textOf(shortcutsOf(action, state.session.preferences)[0]);
}

void run(const Action& action, EditorState& state) {
  if (action.enabled(state)) action.run(state);
}

bool runShortcut(EditorState& state, const RawInput& input) {
  const int key = input.pressedKey >= 0 ? input.pressedKey : input.repeatedKey;
  if (key <= 0 || input.super) return false;
  const bool arrow = key == GLFW_KEY_UP || key == GLFW_KEY_DOWN;
  if (arrow && state.frame.arrowsTaken && !input.control && !input.alt) return false;
  const Action* meant = ownerOf({key, input.control, input.shift, input.alt}, state.session.preferences);
  if (meant == nullptr) return false;
  const bool asked = input.pressedKey >= 0;
  const Possible possible = meant->enabled(state);
  if (asked && !possible) sayRefusal(state, std::string(meant->label) + ": " + possible.reason());
  if (asked || repeats(*meant)) run(*meant, state);
  return true;
}

namespace {

using namespace table;

/// Differences from the keys in the action table.
constexpr KeyChange kBlender[] = {
    {"edit/duplicate", shift(GLFW_KEY_D), ctrl(GLFW_KEY_D)},
    {"edit/delete", key(GLFW_KEY_X), key(GLFW_KEY_DELETE)},
    {"edit/select-all", key(GLFW_KEY_A), ctrl(GLFW_KEY_A)},
    {"edit/select-none", alt(GLFW_KEY_A), key(GLFW_KEY_ESCAPE)},
    {"view/frame", key(GLFW_KEY_KP_DECIMAL), kNone},
    {"view/frame-all", key(GLFW_KEY_HOME), kNone},
    {"tool/select", key(GLFW_KEY_W), kNone},
    {"tool/move", kNone, kNone},
    {"tool/rotate", kNone, kNone},
    {"tool/scale", kNone, kNone},
    {"tool/grab", key(GLFW_KEY_G), kNone},
    {"tool/turn", key(GLFW_KEY_R), kNone},
    {"tool/size", key(GLFW_KEY_S), kNone},
    {"tool/add-muscle", shift(GLFW_KEY_A), key(GLFW_KEY_M)},
    {"tool/box-select", key(GLFW_KEY_B), kNone},
    {"tool/territory", shift(GLFW_KEY_B), kNone},
    {"tool/axes", key(GLFW_KEY_COMMA), kNone},
    {"play/previous", key(GLFW_KEY_LEFT), kNone},
    {"play/next", key(GLFW_KEY_RIGHT), kNone},
    {"play/start", shift(GLFW_KEY_LEFT), kNone},
    {"play/end", shift(GLFW_KEY_RIGHT), kNone},
    {"help/palette", key(GLFW_KEY_F3), ctrl(GLFW_KEY_P)},
};

}  // namespace

std::span<const KeyChange> changesOf(Keymap keymap) {
  return keymap == Keymap::kBlender ? std::span(kBlender) : std::span<const KeyChange>();
}

const char* titleOf(Keymap keymap) { return keymap == Keymap::kBlender ? "Blender-like" : "Maya-like"; }

}  // namespace sinew::app
