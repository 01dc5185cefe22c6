// app/editor/bindings.cpp: the user's keys, stored as differences from the keymap.
#include "app/editor/bindings.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace sinew::app {
namespace {

using Keys = std::array<Shortcut, 2>;

const Action* actionNamed(std::string_view id) {
  const auto found = std::ranges::find(actions(), id, [](const Action& a) { return std::string_view(a.id); });
  return found == actions().end() ? nullptr : &*found;
}

/// Without duplicates, the first key first.
Keys inOrder(Keys keys) {
  if (keys[1] == keys[0]) keys[1] = {};
  if (keys[0].key == 0) std::swap(keys[0], keys[1]);
  return keys;
}

/// Stores keys that differ from the keymap's.
void setKeys(Preferences& preferences, const Action& action, Keys keys) {
  keys = inOrder(keys);
  KeyChanges& changes = preferences.keyChanges();
  if (keys == shortcutsOf(action, preferences.keymap)) {
    changes.erase(action.id);
    return;
  }
  std::vector<std::string> texts;
  for (const Shortcut& shortcut : keys) {
    if (shortcut.key != 0) texts.push_back(textOf(shortcut));
  }
  changes[action.id] = std::move(texts);
}

void takeAway(Preferences& preferences, const Shortcut& shortcut, const Action& keeper) {
  for (const Action& other : actions()) {
    if (&other == &keeper) continue;
    Keys keys = shortcutsOf(other, preferences);
    if (std::ranges::find(keys, shortcut) == keys.end()) continue;
    std::ranges::replace(keys, shortcut, Shortcut{});
    setKeys(preferences, other, keys);
  }
}

/// The usable keys of one entry of the file; adds a note for each other.
Keys usableKeys(const Action& action, const std::vector<std::string>& texts, Keymap keymap,
                std::set<std::string>& given, std::vector<std::string>& notes) {
  Keys keys{};
  std::size_t count = 0;
  const Keys own = shortcutsOf(action, keymap);
  for (const std::string& text : texts) {
    const std::string place = "keys of \"" + std::string(action.label) + "\": \"" + text + "\" ";
    const std::optional<Shortcut> shortcut = shortcutFrom(text);
    if (!shortcut) {
      notes.push_back(place + "is no key");
    } else if (!whyReserved(*shortcut).empty() && std::ranges::find(own, *shortcut) == own.end()) {
      notes.push_back(place + "is reserved");
    } else if (count == keys.size()) {
      notes.push_back(place + "is one too many");
    } else if (!given.insert(text).second) {
      notes.push_back(place + "is used twice");
    } else {
      keys[count++] = *shortcut;
    }
  }
  return keys;
}

void dropUnusable(Preferences& preferences, std::vector<std::string>& notes) {
  const KeyChanges read = std::exchange(preferences.keyChanges(), {});
  std::set<std::string> given;
  std::vector<std::pair<const Action*, Keys>> usable;
  for (const auto& [id, texts] : read) {
    const Action* known = actionNamed(id);
    if (known == nullptr) {
      notes.push_back("keys of \"" + id + "\": no such action");
      continue;
    }
    const Keys keys = usableKeys(*known, texts, preferences.keymap, given, notes);
    // An empty list means no key; a list without a usable key is ignored.
    if (keys[0].key != 0 || texts.empty()) usable.emplace_back(known, keys);
  }
  for (const auto& [known, keys] : usable) setKeys(preferences, *known, keys);
  for (const auto& [known, keys] : usable) {
    for (const Shortcut& shortcut : keys) {
      if (shortcut.key != 0) takeAway(preferences, shortcut, *known);
    }
  }
}

}  // namespace

bool isModifier(int key) {
  return (key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER) ||
         (key >= GLFW_KEY_CAPS_LOCK && key <= GLFW_KEY_NUM_LOCK);
}

std::string whyReserved(const Shortcut& shortcut) {
  if (isModifier(shortcut.key)) return "Modifiers are not keys of their own: hold them and press another key.";
  if (shortcut.key == GLFW_KEY_ESCAPE) return "Esc is reserved: it cancels drags and closes dialogs.";
  if (shortcut.key == GLFW_KEY_ENTER || shortcut.key == GLFW_KEY_KP_ENTER) {
    return "Enter is reserved: it confirms typed numbers and dialogs.";
  }
  if (shortcut.key == GLFW_KEY_PRINT_SCREEN || shortcut.key == GLFW_KEY_MENU) return "The desktop uses this key.";
  if (!shortcutFrom(textOf(shortcut))) return "This key has no name and cannot be saved.";
  return "";
}

const Action* ownerOf(const Shortcut& shortcut, const Preferences& preferences) {
  for (const Action& candidate : actions()) {
    const Keys keys = shortcutsOf(candidate, preferences);
    if (shortcut.key != 0 && std::ranges::find(keys, shortcut) != keys.end()) return &candidate;
  }
  return nullptr;
}

bool isRebound(const Action& action, const Preferences& preferences) {
  return preferences.keyChanges().contains(action.id);
}

void giveKey(Preferences& preferences, const Action& action, std::size_t slot, const Shortcut& shortcut) {
  takeAway(preferences, shortcut, action);
  Keys keys = shortcutsOf(action, preferences);
  std::ranges::replace(keys, shortcut, Shortcut{});
  keys[slot] = shortcut;
  setKeys(preferences, action, keys);
}

void resetAllKeys(Preferences& preferences) { preferences.keyChanges().clear(); }

std::vector<std::string> dropUnusableKeys(Preferences& preferences) {
  std::vector<std::string> notes;
  const Keymap chosen = preferences.keymap;
  for (const Keymap keymap : kKeymaps) {
    preferences.keymap = keymap;
    dropUnusable(preferences, notes);
  }
  preferences.keymap = chosen;
  return notes;
}

namespace {

void clearKey(Preferences& preferences, const Action& action, std::size_t slot) {
  Keys keys = shortcutsOf(action, preferences);
  keys[slot] = {};
  setKeys(preferences, action, keys);
}

/// Back to the keymap's keys.
void resetKeys(Preferences& preferences, const Action& action) {
  const Keys keys = shortcutsOf(action, preferences.keymap);
  for (const Shortcut& shortcut : keys) {
    if (shortcut.key != 0) takeAway(preferences, shortcut, action);
  }
  setKeys(preferences, action, keys);
}

/// Actions that would lose a key to resetKeys().
std::vector<const Action*> losersToReset(const Preferences& preferences, const Action& action) {
  std::vector<const Action*> losers;
  for (const Shortcut& shortcut : shortcutsOf(action, preferences.keymap)) {
    const Action* owner = ownerOf(shortcut, preferences);
    if (owner != nullptr && owner != &action && std::ranges::find(losers, owner) == losers.end()) {
      losers.push_back(owner);
    }
  }
  return losers;
}

bool clears(const Shortcut& pressed) {
  const bool plain = !pressed.control && !pressed.shift && !pressed.alt;
  return plain && (pressed.key == GLFW_KEY_BACKSPACE || pressed.key == GLFW_KEY_DELETE);
}

std::string quoted(const Action& action) { return '"' + std::string(action.label) + '"'; }

}  // namespace

void startKeyCapture(EditorState& state, const Action& action, int slot) {
  state.dialogs.keyCapture = {KeyCapture::Step::kWaiting, action.id, slot, "", ""};
}

void captureKey(EditorState& state, const Shortcut& pressed) {
  KeyCapture& capture = state.dialogs.keyCapture;
  if (capture.step != KeyCapture::Step::kWaiting) return;
  Preferences& preferences = state.session.preferences;
  const Action& wanted = action(capture.action);
  const auto slot = static_cast<std::size_t>(capture.slot);
  if (pressed.key == GLFW_KEY_ESCAPE) return endKeyCapture(state);
  if (clears(pressed)) {
    clearKey(preferences, wanted, slot);
    return endKeyCapture(state);
  }
  capture.notice = whyReserved(pressed);
  if (!capture.notice.empty()) return;
  const Action* owner = ownerOf(pressed, preferences);
  if (owner != nullptr && owner != &wanted) {
    capture.step = KeyCapture::Step::kAsking;
    capture.key = textOf(pressed);
    capture.notice = capture.key + " belongs to " + quoted(*owner) + ". Replace it?";
    return;
  }
  giveKey(preferences, wanted, slot, pressed);
  endKeyCapture(state);
}

void requestKeyReset(EditorState& state, const Action& action) {
  const auto losers = losersToReset(state.session.preferences, action);
  if (losers.empty()) {
    resetKeys(state.session.preferences, action);
    return endKeyCapture(state);
  }
  std::string names;
  for (const Action* loser : losers) names += (names.empty() ? "" : " and ") + quoted(*loser);
  state.dialogs.keyCapture = {KeyCapture::Step::kAsking, action.id, 0, "",
                              "The keymap's keys belong to " + names + ". Replace them?"};
}

void replaceKeys(EditorState& state) {
  const KeyCapture asked = std::exchange(state.dialogs.keyCapture, {});
  if (asked.step != KeyCapture::Step::kAsking) return;
  Preferences& preferences = state.session.preferences;
  if (asked.key.empty()) {
    resetKeys(preferences, action(asked.action));
  } else if (const auto key = shortcutFrom(asked.key)) {
    giveKey(preferences, action(asked.action), static_cast<std::size_t>(asked.slot), *key);
  }
}

void endKeyCapture(EditorState& state) { state.dialogs.keyCapture = {}; }

}  // namespace sinew::app
