// app/editor/key_capture.h: giving an action another key: waiting for the key, and the question if it is taken.
#pragma once

#include "app/editor/bindings.h"

namespace sinew::app {

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
