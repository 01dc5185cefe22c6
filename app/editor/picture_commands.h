// app/editor/picture_commands.h: saving pictures, turntables and contact sheets.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

// File > Export > Turntable or contact sheet.

void showPicturesDialog(EditorState& state);  ///< Keeps the last choices; paths start beside each document.
void closePicturesDialog(Dialogs& dialogs);

[[nodiscard]] ExportPlace& picturesPlace(PicturesDialogState& dialog);  ///< Path of the chosen output.
void browseForPicturesPlace(EditorState& state);
/// Takes the path dialog's file. @param file  absolute
void takePicturesPlace(PicturesDialogState& dialog, const std::filesystem::path& file);
/// @param ending  .webp, .gif or .mp4, also for the turntable's name
void choosePicturesEnding(PicturesDialogState& dialog, const std::string& ending);
/// The output with its ending; "" without a name.
[[nodiscard]] std::filesystem::path picturesFile(PicturesDialogState& dialog);

[[nodiscard]] int pictureCount(const EditorState& state);
[[nodiscard]] double turntableSeconds(const EditorState& state);
/// Arguments of `sinew render` without input and output: look, view and clip as shown.
[[nodiscard]] std::vector<std::string> pictureArguments(const EditorState& state);

/// Draws in the background; asks before replacing a file. @return false: the dialog shows why it is not done
bool confirmPictures(EditorState& state);

// A single picture, which the window writes (SessionState::pictureWanted).

void showPictureDialog(EditorState& state);  ///< Asks for a path, starting in the folder of the last picture.
void savePictureNow(EditorState& state);     ///< Saves into that folder under a free name: "fox-2026-11-21-043512.png".
void wantPicture(EditorState& state, const std::filesystem::path& file);  ///< The window writes it after this frame.

/// The first existing of XDG_PICTURES_DIR in $XDG_CONFIG_HOME/user-dirs.dirs, ~/Pictures, ~.
[[nodiscard]] std::filesystem::path picturesFolder();
[[nodiscard]] std::filesystem::path withPictureEnding(std::filesystem::path file);  ///< Appends ".png" if needed.

}  // namespace sinew::app
