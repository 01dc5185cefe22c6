// app/editor/clip_commands.h: clips of other files: adding, removing, locating and reading them again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// One undo step: adds the file to the rig and plays its first clip; a known file is read again. Opens the list if
/// something did not match. @return "", or why it failed (also a message)
std::string addClips(EditorState& state, const std::filesystem::path& file);
void readClipFilesAgain(EditorState& state);  ///< Reads the rig's clip files again. No undo step.
/// One undo step. Keys for the removed clips stay until the file is added again; keys of renamed clips follow.
/// @param file  index into Rig::clipFiles
void removeClipFile(EditorState& state, int file);
/// One undo step: replaces a missing file. @return as addClips()
std::string locateClipFile(EditorState& state, const std::string& name, const std::filesystem::path& file);

void showClipsDialog(EditorState& state);  ///< The path dialog for addClips().
/// The path dialog for locateClipFile(). @param file  index into Rig::clipFiles
void showLocateClipsDialog(EditorState& state, int file);
void showClipList(EditorState& state);  ///< Play > Clip files. Closes other panels in the same place.
void toggleClipList(EditorState& state);

/// Reads clip files again if an edit, undo or redo changed them. A clip that still exists plays on.
void followClipFiles(EditorState& state);

/// The transport for a character with other clips; nullopt: the shown clip does not exist.
[[nodiscard]] std::optional<Transport> carriedOver(const Transport& transport, const Character& before,
                                                   const Character& after);

/// Content of a dropped file for the open character.
struct DroppedClips {
  bool any = false;          ///< It has clips.
  bool nothingElse = false;  ///< ... and no mesh, or the bones of the open character.
};
[[nodiscard]] DroppedClips lookForClips(const Document& document, const std::filesystem::path& file);

}  // namespace sinew::app
