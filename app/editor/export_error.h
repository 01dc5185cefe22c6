// app/editor/export_error.h: the error of the last export, shown in the picture.
#pragma once

#include <cstdint>
#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

void keepExport(EditorState& state, const ExportOutcome& outcome);  ///< Keeps the export in place of the last one.

[[nodiscard]] bool hasExportError(const EditorState& state);  ///< The last export is of this character and has figures.
[[nodiscard]] bool showsExportError(const EditorState& state);  ///< ... and it is shown.
void toggleExportError(EditorState& state);
void showExported(EditorState& state, ExportedView view);  ///< Shows the error on one mesh, or on both side by side.
[[nodiscard]] bool showsExportBeside(const EditorState& state);  ///< The exported mesh stands beside the live one.
void toggleExportBeside(EditorState& state);
/// If both meshes are shown, places them side by side for the camera's target view and frames them.
/// @return whether they are shown
bool frameExportBeside(EditorState& state);
void showLargestError(EditorState& state);  ///< Goes to the time of the largest error and centers its vertex.

/// End of the color scale: the largest error of all times, percent of the height.
[[nodiscard]] float exportErrorRange(const EditorState& state);
/// "largest 6.9 % in "Walk" at 0.31 s on thigh.L"
[[nodiscard]] std::string largestErrorText(const EditorState& state);

void updateExportError(EditorState& state);  ///< Once a frame, after the live surface: updates the error's surface.
/// The picture's surface: the live one, or the one with the error.
[[nodiscard]] const Surface& shownSurface(const EditorState& state);
/// The exported mesh beside it, with the same refinement, or null.
[[nodiscard]] const Surface* besideSurface(const EditorState& state);
[[nodiscard]] std::uint64_t shownRevision(const EditorState& state);  ///< Different for each pair of these surfaces.

}  // namespace sinew::app
