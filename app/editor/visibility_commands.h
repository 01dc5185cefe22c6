// app/editor/visibility_commands.h: hide, isolate, before and after; from keys, menus and the outliner.
#pragma once

#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// Once a frame, before the surface is brought up to date: marks follow renamed muscles, new ones appear.
void followEdits(Document& document);

/// Hides the selected muscles; shows them if all of them are hidden by themselves.
void toggleHideSelection(Document& document);
/// Show every muscle: hide, solo and isolate end; locks stay.
void showAll(Document& document);
/// Shows the selected muscles alone, or ends that.
void toggleIsolation(Document& document);
void toggleLockSelection(Document& document);
void unlockAll(Document& document);

/// Something is hidden, soloed or isolated.
[[nodiscard]] bool anythingHidden(const Document& document);

/// The menu's and the key's part of "before": the key goes down, or the menu entry is chosen.
void latchBare(EditorState& state);
/// Once a frame. @param keyDown  the action's key is held  @param buttonDown  its button is
void holdBare(EditorState& state, bool keyDown, bool buttonDown);

/// "2 of 15 muscles hidden" or "".
[[nodiscard]] std::string hiddenText(const Document& document);

}  // namespace sinew::app
