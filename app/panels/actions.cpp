// app/panels/actions.cpp: finding and running actions. The table itself is action_table.cpp.

#include "app/panels/actions.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace sinew::app {
namespace {

struct KeyName {
  int key;
  const char* name;
};

constexpr std::array kKeyNames{
    KeyName{GLFW_KEY_SPACE, "Space"}, KeyName{GLFW_KEY_DELETE, "Del"},  KeyName{GLFW_KEY_ESCAPE, "Esc"},
    KeyName{GLFW_KEY_LEFT, "Left"},   KeyName{GLFW_KEY_RIGHT, "Right"}, KeyName{GLFW_KEY_HOME, "Home"},
    KeyName{GLFW_KEY_END, "End"},     KeyName{GLFW_KEY_COMMA, ","},     KeyName{GLFW_KEY_PERIOD, "."},
    KeyName{GLFW_KEY_KP_0, "Num 0"},  KeyName{GLFW_KEY_KP_1, "Num 1"},  KeyName{GLFW_KEY_KP_3, "Num 3"},
    KeyName{GLFW_KEY_KP_5, "Num 5"},  KeyName{GLFW_KEY_KP_7, "Num 7"},  KeyName{GLFW_KEY_BACKSPACE, "Backspace"},
};

std::string nameOfKey(int key) {
  if (const auto found = std::ranges::find(kKeyNames, key, &KeyName::key); found != kKeyNames.end()) return found->name;
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  return std::string(1, static_cast<char>(key));
}

bool repeats(const Action& action) {
  const std::string_view id = action.id;
  return id == "edit/undo" || id == "edit/redo" || id == "play/next" || id == "play/previous";
}

}  // namespace

const Action& action(std::string_view id) {
  const auto found = std::ranges::find(actions(), id, [](const Action& a) { return std::string_view(a.id); });
  assert(found != actions().end());
  return *found;
}

std::string textOf(const Shortcut& shortcut) {
  if (shortcut.key == 0) return "";
  std::string text;
  if (shortcut.control) text += "Ctrl+";
  if (shortcut.shift) text += "Shift+";
  return text + nameOfKey(shortcut.key);
}

void run(const Action& action, EditorState& state) {
  if (action.enabled(state)) action.run(state);
}

bool runShortcut(EditorState& state, const InputFrame& input) {
  const int key = input.pressedKey >= 0 ? input.pressedKey : input.repeatedKey;
  if (key < 0 || input.alt || input.super) return false;
  const Shortcut pressed{key, input.control, input.shift};
  for (const Action& candidate : actions()) {
    if (candidate.shortcut != pressed && candidate.second != pressed) continue;
    if (input.pressedKey >= 0 || repeats(candidate)) run(candidate, state);
    return true;
  }
  return false;
}

}  // namespace sinew::app
