// app/editor/bindings.h: the user's own keys for actions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/actions.h"

namespace sinew::app {

[[nodiscard]] std::optional<Shortcut> shortcutFrom(std::string_view text);  ///< Inverse of textOf(); nullopt: no key.
[[nodiscard]] std::string whyReserved(const Shortcut& shortcut);  ///< A sentence why no action may have the key, or "".
[[nodiscard]] bool isModifier(int key);                           ///< Shift, Ctrl, Alt, Super or a lock key.

/// The key's action, or null.
[[nodiscard]] const Action* ownerOf(const Shortcut& shortcut, const Preferences& preferences);
/// It has other keys than in the keymap.
[[nodiscard]] bool isRebound(const Action& action, const Preferences& preferences);

/// In the chosen keymap; a former action of the key loses it. @param slot  0 or 1; without a first key: the first
void giveKey(Preferences& preferences, const Action& action, std::size_t slot, const Shortcut& shortcut);
void resetAllKeys(Preferences& preferences);

/// Removes unusable entries of a preferences file from both keymaps: unknown actions, unknown or reserved keys,
/// duplicates. The user's keys take precedence over the keymap's. @return a line for each
[[nodiscard]] std::vector<std::string> dropUnusableKeys(Preferences& preferences);

// Assigning a key interactively.

/// The next key press goes to this action. @param slot  0 or 1
void startKeyCapture(EditorState& state, const Action& action, int slot);
/// Esc cancels, Backspace and Delete clear, reserved keys are refused; asks before taking another action's key.
void captureKey(EditorState& state, const Shortcut& pressed);
/// Resets keys, after a question if another action would lose one.
void requestKeyReset(EditorState& state, const Action& action);
void replaceKeys(EditorState& state);  ///< The question was answered with Replace.
void endKeyCapture(EditorState& state);

}  // namespace sinew::app
