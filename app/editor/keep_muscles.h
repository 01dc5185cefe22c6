// app/editor/keep_muscles.h: the muscles of the open rig on another character, as a new document.
#pragma once

#include <filesystem>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// A file let go over the window. One that holds clips for the open character and nothing else adds them (addClips()).
/// If it is another character and there are muscles, Dialogs::keepMuscles asks what becomes of them; else it is opened
/// (request()).
void dropFile(EditorState& state, const std::filesystem::path& file);
/// The file dialog for the character that gets the muscles.
void showRetargetDialog(EditorState& state);

/// Opens the character with the muscles of the open rig (core/bodies/retarget.h), unsaved: one undo step. Messages name
/// what was left out and mended. Where that fails the open document stays, and a message says why.
void openWithMuscles(EditorState& state, const std::filesystem::path& file);

}  // namespace sinew::app
