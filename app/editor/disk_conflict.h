// app/editor/disk_conflict.h: files that other programs change while they are open. Saving asks before it overwrites a
// changed rig; character and clip files are watched too.
#pragma once

#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// Asks if the rig's file was changed or removed. @return whether it asks; write nothing until it is answered
bool asksBeforeSaving(EditorState& state, const Intent& then);

/// The answers. Each but the last then performs the intent that waited for the save.
void saveBeside(EditorState& state);      ///< Saves under a new name.
void discardForDisk(EditorState& state);  ///< Discards the changes here; without an intent, reopens the file.
void saveOverDisk(EditorState& state);    ///< Overwrites the file.
void leaveUnsaved(EditorState& state);

/// Call regularly: reports once that the rig's file was changed or removed.
void watchDisk(EditorState& state);

/// Call regularly: reports once for each file that was read, buffers of a .gltf included, that it was changed or
/// removed. Changed clip files are in ClipListState::changed until they are read again or restored.
void watchReadFiles(EditorState& state);

}  // namespace sinew::app
