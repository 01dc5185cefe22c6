// app/editor/picture_commands.h: the picture goes to a file. The window writes it (SessionState::pictureWanted).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

// File > Export > Turntable or contact sheet: its dialog, and the job that it starts.

/// Begins with what was chosen before; places begin anew with each document: beside the rig.
void showPicturesDialog(EditorState& state);
void closePicturesDialog(Dialogs& dialogs);

/// Where what is chosen goes.
[[nodiscard]] ExportPlace& picturesPlace(PicturesDialogState& dialog);
void browseForPicturesPlace(EditorState& state);
/// What the path dialog has given. @param file  absolute
void takePicturesPlace(PicturesDialogState& dialog, const std::filesystem::path& file);
/// .webp, .gif or .mp4: the name of the turntable follows.
void choosePicturesEnding(PicturesDialogState& dialog, const std::string& ending);
/// The file that is written, with its ending; "" without a name.
[[nodiscard]] std::filesystem::path picturesFile(PicturesDialogState& dialog);

/// How many pictures the job draws.
[[nodiscard]] int pictureCount(const EditorState& state);
/// How long the turntable lasts.
[[nodiscard]] double turntableSeconds(const EditorState& state);
/// What `sinew render` is told, without input and output: the look of the picture that is shown, from where it is seen,
/// in its clip.
[[nodiscard]] std::vector<std::string> pictureArguments(const EditorState& state);

/// What the dialog's button does: the pictures are made in the background. Before it replaces a file it asks, in the
/// dialog. @return whether the dialog is done; else it says why not.
bool confirmPictures(EditorState& state);

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
