// app/editor/edit.h: edits by commands and panels (tools use the command stack directly), refusals, toasts and
// messages.
#pragma once

#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// Applies an edit as one undo step, or as part of the active field's; a refusal goes to refuse().
/// @return whether it was accepted
bool edit(EditorState& state, const std::string& label, Result<Rig> rig);

/// Reports a refused edit in a toast and a message, once for a drag that is refused in every frame.
void refuse(EditorState& state, const Error& error);

/// Call when a field loses focus: reports why its last value was refused, if it was.
void sayRefusedField(EditorState& state);

void say(EditorState& state, const std::string& text);         ///< Shows a toast.
void sayRefusal(EditorState& state, const std::string& text);  ///< Shows a toast about what was not done, and why.

/// One undo step: takes the transport's pose made by hand.
void keepPose(EditorState& state, const std::string& label);

void keepPlayRange(EditorState& state);  ///< One undo step: takes the transport's play ranges.

/// Adds a message; a repeated one counts up and becomes the newest.
void addMessage(SessionState& session, MessageKind kind, const std::string& text,
                MessageAbout about = MessageAbout::kDocument);
/// The same where a toast has it already: the list need not open.
void addQuietly(SessionState& session, MessageKind kind, const std::string& text,
                MessageAbout about = MessageAbout::kDocument);
/// Another document is open: what was said of the one before goes.
void forgetDocumentMessages(SessionState& session);

}  // namespace sinew::app
