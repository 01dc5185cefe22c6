// app/editor/edit.h: how commands and panels edit (tools write to the command stack themselves), and how refusals are
// shown.
#pragma once

#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// One undo step, or part of the one of the field that is being edited; or, if it was refused, nothing but refuse().
/// @return whether it was accepted.
bool edit(EditorState& state, const std::string& label, Result<Rig> rig);

/// Says why an edit was refused: in the status line until the next accepted edit, and among the messages.
void refuse(EditorState& state, const Error& error);

/// One undo step: the pose made by hand is as the transport has it now.
void keepPose(EditorState& state, const std::string& label);

/// Adds a line to the messages; said again, it counts up.
void addMessage(SessionState& session, MessageKind kind, const std::string& text);

}  // namespace sinew::app
