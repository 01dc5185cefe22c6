// app/editor/open_file.h: a file becomes the open document.
#pragma once

#include <filesystem>
#include <string>

#include "app/document/document.h"
#include "app/editor/editor_state.h"

namespace sinew::app {

// The muscles of the open rig on another character, as a new document.

/// A file let go over the window. One that holds clips for the open character and nothing else adds them (addClips()).
/// If it is another character and there are muscles, Dialogs::keepMuscles asks what becomes of them; else it is opened
/// (request()).
void dropFile(EditorState& state, const std::filesystem::path& file);
/// The file dialog for the character that gets the muscles.
void showRetargetDialog(EditorState& state);

/// Opens the character with the muscles of the open rig (core/bodies/retarget.h), unsaved: one undo step. Messages name
/// what was left out and mended. Where that fails the open document stays, and a message says why.
void openWithMuscles(EditorState& state, const std::filesystem::path& file);

/// Opens at once, without asking about changes. On an error the open document stays, and a message says why; where
/// only the character is missing, Dialogs::locate asks for it.
/// A walk plays if there is one (core/character/clip_names.h); a file that was open before looks as it was left
/// (view_memory.h). @return whether it was opened.
bool openFile(EditorState& state, const std::filesystem::path& file);
/// The same with what has been read already.
bool showDocument(EditorState& state, Document document);
/// The document's own file again, as it is on disk; what plays, the camera and turned bones stay.
void reopen(EditorState& state);

// A rig whose character is not where the rig says opens with one that the user names.
/// From the question (Dialogs::locate) to the file dialog: at the rig's folder, with the file of the missing one's name
/// if there is one.
void showLocateDialog(EditorState& state);
/// The rig with this character; the path to it is an unsaved change. @return an empty text, or why it failed: then the
/// open document stays.
std::string openWithCharacter(EditorState& state, const std::filesystem::path& rigFile,
                              const std::filesystem::path& characterFile);

}  // namespace sinew::app
