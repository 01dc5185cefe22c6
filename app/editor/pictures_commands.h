// app/editor/pictures_commands.h: File > Export > Turntable or contact sheet: its dialog, and the job that it starts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

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

}  // namespace sinew::app
