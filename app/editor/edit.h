// app/editor/edit.h: edits by commands and panels (tools use the command stack), refusals, toasts and messages.
#pragma once

#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// One undo step, or part of the active field's; a refusal goes to refuse(). @return whether it was accepted
bool edit(EditorState& state, const std::string& label, Result<Rig> rig);

/// Reports a refused edit in a toast and a message, once for a drag that is refused in every frame.
void refuse(EditorState& state, const Error& error);

void sayRefusedField(EditorState& state);  ///< When a field loses focus: reports why its last value was refused.

void say(EditorState& state, const std::string& text);         ///< Shows a toast.
void sayRefusal(EditorState& state, const std::string& text);  ///< Shows a toast about what was not done, and why.

void keepPose(EditorState& state, const std::string& label);  ///< One undo step: the transport's pose made by hand.

void keepPlayRange(EditorState& state);  ///< One undo step: takes the transport's play ranges.

/// Adds a message; a repeated one counts up and becomes the newest.
void addMessage(SessionState& session, MessageKind kind, const std::string& text,
                MessageAbout about = MessageAbout::kDocument);
/// The same where a toast has it already: the list need not open.
void addQuietly(SessionState& session, MessageKind kind, const std::string& text,
                MessageAbout about = MessageAbout::kDocument);
void forgetDocumentMessages(SessionState& session);  ///< Removes messages about the document before.

}  // namespace sinew::app
