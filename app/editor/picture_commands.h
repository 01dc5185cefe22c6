// app/editor/picture_commands.h: the picture goes to a file. The window writes it (SessionState::pictureWanted).
#pragma once

#include <filesystem>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// Asks for a place, first the folder of the last picture.
void showPictureDialog(EditorState& state);
/// Into that folder at once, under a name that is free: "fox-2026-11-21-043512.png".
void savePictureNow(EditorState& state);
/// The window writes the picture there after this frame.
void wantPicture(EditorState& state, const std::filesystem::path& file);

/// The user's own folder for pictures: XDG_PICTURES_DIR in $XDG_CONFIG_HOME/user-dirs.dirs, else ~/Pictures, else ~;
/// the first that is there.
[[nodiscard]] std::filesystem::path picturesFolder();
/// ".png" is appended unless it ends so.
[[nodiscard]] std::filesystem::path withPictureEnding(std::filesystem::path file);

}  // namespace sinew::app
