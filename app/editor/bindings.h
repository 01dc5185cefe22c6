// app/editor/bindings.h: the keys that the user gave to actions in place of the keymap's.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/actions.h"

namespace sinew::app {

/// "Ctrl+Shift+S" -> the key, in the order in which textOf writes modifiers; nothing for a text that names no key.
[[nodiscard]] std::optional<Shortcut> shortcutFrom(std::string_view text);
/// Why no action may be given this key, a sentence; "" if one may.
[[nodiscard]] std::string whyReserved(const Shortcut& shortcut);
/// Shift, Ctrl, Alt, Super or a lock key.
[[nodiscard]] bool isModifier(int key);

/// The action that the key runs; null: none.
[[nodiscard]] const Action* ownerOf(const Shortcut& shortcut, const Preferences& preferences);
/// It has other keys than the keymap gives it.
[[nodiscard]] bool isRebound(const Action& action, const Preferences& preferences);

// Changes to the chosen keymap. A key has one owner: who had it before loses it.
/// @param slot  0 or 1; without a first key it becomes the first
void giveKey(Preferences& preferences, const Action& action, std::size_t slot, const Shortcut& shortcut);
void clearKey(Preferences& preferences, const Action& action, std::size_t slot);
/// Back to the keymap's keys.
void resetKeys(Preferences& preferences, const Action& action);
/// Who would lose a key to resetKeys.
[[nodiscard]] std::vector<const Action*> losersToReset(const Preferences& preferences, const Action& action);
void resetAllKeys(Preferences& preferences);

/// Removes from both keymaps what a file may say and nobody can use: unknown actions, unknown or reserved keys, a key
/// that stands twice. A key given by the user is taken from the action that the keymap gives it to.
/// @return a line on each
[[nodiscard]] std::vector<std::string> dropUnusableKeys(Preferences& preferences);

// Giving an action another key: waiting for the key, and the question if it is taken.

/// The next key is for this action. @param slot  0 or 1
void startKeyCapture(EditorState& state, const Action& action, int slot);
/// What was pressed while a key is waited for: Esc gives up, Backspace and Delete clear, a reserved key is refused and
/// another one waited for, a key that is taken becomes a question; any other key is given.
void captureKey(EditorState& state, const Shortcut& pressed);
/// Back to the keymap's keys; a question first if another action would lose one.
void requestKeyReset(EditorState& state, const Action& action);
/// The question is answered with Replace.
void replaceKeys(EditorState& state);
/// Neither waits nor asks any more.
void endKeyCapture(EditorState& state);

}  // namespace sinew::app
