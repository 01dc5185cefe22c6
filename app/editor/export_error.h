// app/editor/export_error.h: how far the last export is off, shown in the picture.
#pragma once

#include <cstdint>
#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// Keeps what an export has come to; the one before is forgotten.
void keepExport(EditorState& state, const ExportOutcome& outcome);

/// There is an export of the open character with figures.
[[nodiscard]] bool hasExportError(const EditorState& state);
/// ... and it is shown.
[[nodiscard]] bool showsExportError(const EditorState& state);
void toggleExportError(EditorState& state);
/// Shows the error on one mesh or on both, which are then brought into the picture side by side.
void showExported(EditorState& state, ExportedView view);
/// The exported mesh stands beside the live one.
[[nodiscard]] bool showsExportBeside(const EditorState& state);
void toggleExportBeside(EditorState& state);
/// Where both are shown: puts them side by side as they are seen from where the camera stands or goes to, and frames
/// them. @return false: they are not, and nothing was done.
bool frameExportBeside(EditorState& state);
/// The moment of the largest distance, the vertex in the middle of the picture.
void showLargestError(EditorState& state);

/// What the scale of colors ends at, percent of the height: the largest distance of all moments.
[[nodiscard]] float exportErrorRange(const EditorState& state);
/// "largest 6.9 % in "Walk" at 0.31 s on thigh.L"
[[nodiscard]] std::string largestErrorText(const EditorState& state);

/// Once a frame, after the live surface: brings the picture's surface to the moment.
void updateExportError(EditorState& state);
/// What the picture shows: the live surface, or that with the error.
[[nodiscard]] const Surface& shownSurface(const EditorState& state);
/// The exported mesh beside it, of the same refinement; null: it is not shown.
[[nodiscard]] const Surface* besideSurface(const EditorState& state);
/// Its number: another one for each surface, and for what stands beside it.
[[nodiscard]] std::uint64_t shownRevision(const EditorState& state);

}  // namespace sinew::app
