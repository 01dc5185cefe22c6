// app/editor/edit.h: how commands and panels edit (tools write to the command stack themselves), and how refusals are
// shown.
#pragma once

#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// One undo step, or part of the one of the field that is being edited; or, if it was refused, nothing but refuse().
/// @return whether it was accepted.
bool edit(EditorState& state, const std::string& label, Result<Rig> rig);

/// Says why an edit was refused: at once in a toast, and among the messages. A drag that is refused in every frame is
/// one refusal.
void refuse(EditorState& state, const Error& error);

/// A field is left whose last value was refused: says why. Nothing if it was accepted.
void sayRefusedField(EditorState& state);

/// A toast: what has been done.
void say(EditorState& state, const std::string& text);
/// A toast: what has not been done, and why.
void sayRefusal(EditorState& state, const std::string& text);

/// One undo step: the pose made by hand is as the transport has it now.
void keepPose(EditorState& state, const std::string& label);

/// One undo step: the parts of clips that play are as the transport has them now.
void keepPlayRange(EditorState& state);

/// Adds a line to the messages; said again, it counts up and becomes the newest.
void addMessage(SessionState& session, MessageKind kind, const std::string& text,
                MessageAbout about = MessageAbout::kDocument);
/// The same where a toast has it already: the list need not open.
void addQuietly(SessionState& session, MessageKind kind, const std::string& text,
                MessageAbout about = MessageAbout::kDocument);
/// Another document is open: what was said of the one before goes.
void forgetDocumentMessages(SessionState& session);

}  // namespace sinew::app
