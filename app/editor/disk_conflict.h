// app/editor/disk_conflict.h: the rig's file is no longer what this window read or wrote last: another program,
// another window or version control has changed it. Nothing is written over it unasked. Files that are only read, the
// character's and those of added clips, are watched too.
#pragma once

#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// Asks if the document's own file has changed or gone since. @return whether the question is open now: then nothing
/// may be written before it is answered.
bool asksBeforeSaving(EditorState& state, const Intent& then);

/// The answers. After each the intent that waited for the save is carried out.
void saveBeside(EditorState& state);      ///< Both stay: this one under a new name beside the other.
void discardForDisk(EditorState& state);  ///< The other one counts: it is read again, or the intent takes its place.
void saveOverDisk(EditorState& state);    ///< This one counts.
void leaveUnsaved(EditorState& state);    ///< Nothing happens.

/// Called now and then: says once that the file has changed or gone under the open document.
void watchDisk(EditorState& state);

/// Called now and then: says once of each file that it holds something else than was read, or has gone. Files of clips
/// are in ClipListState::changed until they are read again, or hold what was read once more. Of a .gltf its buffers
/// count too.
void watchReadFiles(EditorState& state);

}  // namespace sinew::app
