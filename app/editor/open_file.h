// app/editor/open_file.h: opening files.
#pragma once

#include <filesystem>
#include <string>

#include "app/document/document.h"
#include "app/editor/editor_state.h"

namespace sinew::app {

// Files that other programs change: saving asks before it overwrites such a rig; character and clip files are watched.

/// Asks if the rig's file was changed or removed. @return whether it asks; write nothing until it is answered
bool asksBeforeSaving(EditorState& state, const Intent& then);

/// The answers. Each but the last then performs the intent that waited for the save.
void saveBeside(EditorState& state);      ///< Saves under a new name.
void discardForDisk(EditorState& state);  ///< Discards the changes here; without an intent, reopens the file.
void saveOverDisk(EditorState& state);    ///< Overwrites the file.
void leaveUnsaved(EditorState& state);

void watchDisk(EditorState& state);  ///< Call regularly: reports once that the rig's file was changed or removed.

/// Call regularly: reports once for each file that was read, buffers of a .gltf included, that it was changed or
/// removed. Changed clip files are in ClipListState::changed until they are read again or restored.
void watchReadFiles(EditorState& state);

/// Handles a dropped file. Adds clips from a file that has nothing else for the open character; for another character
/// asks about the open muscles (Dialogs::keepMuscles), if there are any; else opens the file.
void dropFile(EditorState& state, const std::filesystem::path& file);
void showRetargetDialog(EditorState& state);  ///< The path dialog for openWithMuscles().

/// Opens a character with the muscles of the open rig (core/bodies/retarget.h) as one unsaved step. Messages name
/// muscles that were left out or mended. On failure the open document stays, with a message.
void openWithMuscles(EditorState& state, const std::filesystem::path& file);

/// Opens a file without asking about changes. On failure the open document stays, with a message; if only the character
/// is missing, Dialogs::locate asks for it. Plays a walk if there is one (core/character/clip_names.h), or restores the
/// file's last view (view_memory.h). @return whether it was opened
bool openFile(EditorState& state, const std::filesystem::path& file);
bool showDocument(EditorState& state, Document document);  ///< The same for a document that was read already.
void reopen(EditorState& state);  ///< Opens the document's file again; keeps clip, camera and pose.

/// The path dialog after Dialogs::locate: in the rig's folder, with a file of the missing one's name if it exists.
void showLocateDialog(EditorState& state);
/// Opens the rig with this character, whose path is an unsaved change. @return "", or why it failed
std::string openWithCharacter(EditorState& state, const std::filesystem::path& rigFile,
                              const std::filesystem::path& characterFile);

}  // namespace sinew::app
