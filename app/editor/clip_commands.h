// app/editor/clip_commands.h: clips of other files: added, removed, located, and what plays while they come and go.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// One undo step: the rig names the file, and its first clip plays. A file that it names already is read again. The
/// list opens where something did not match. @return an empty text, or why it failed (also a message): nothing has
/// changed
std::string addClips(EditorState& state, const std::filesystem::path& file);
/// No step: what other programs have made of the files that the rig names.
void readClipFilesAgain(EditorState& state);
/// One undo step. Keys stay: those of clips that go wait for the file to be added again, the others' follow clips that
/// are called otherwise from then on. @param file  index into Rig::clipFiles
void removeClipFile(EditorState& state, int file);
/// One undo step: another file takes the place of one that is gone. @return as addClips
std::string locateClipFile(EditorState& state, const std::string& name, const std::filesystem::path& file);

/// The file dialog for addClips().
void showClipsDialog(EditorState& state);
/// ... for locateClipFile(). @param file  index into Rig::clipFiles
void showLocateClipsDialog(EditorState& state, int file);
/// Play > Clip files. What shares its place closes.
void showClipList(EditorState& state);
void toggleClipList(EditorState& state);

/// After an edit, undo or redo that changed which files there are: the character's clips follow. What plays goes on
/// where its clip is still there.
void followClipFiles(EditorState& state);

/// The transport for a character with other clips; nullopt: the clip that it shows is not there.
[[nodiscard]] std::optional<Transport> carriedOver(const Transport& transport, const Character& before,
                                                   const Character& after);

/// Clips that come from a file. @param file  as the rig names it
[[nodiscard]] std::vector<std::string> clipsOf(const Character& character, const std::string& file);

/// What a file that was let go over the window holds for the open character.
struct DroppedClips {
  bool any = false;          ///< It has clips.
  bool nothingElse = false;  ///< ... and no mesh, or the bones of the open character: another file of the same one.
};
[[nodiscard]] DroppedClips lookForClips(const Document& document, const std::filesystem::path& file);

}  // namespace sinew::app
