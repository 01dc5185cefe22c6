// app/editor/fit_sculpt_commands.h: Muscles > Fit to a sculpt: one undo step, which the panel's sliders make again.
#pragma once

#include <filesystem>
#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

void showSculptDialog(EditorState& state);  ///< Asks for the sculpt's file.
/// Reads a sculpt, opens the panel and begins a fit. @return why it cannot be read, or ""
std::string takeSculpt(EditorState& state, const std::filesystem::path& file);

[[nodiscard]] bool isFitting(const EditorState& state);
[[nodiscard]] double fitShare(const EditorState& state);  ///< Done, 0..1, while fitting.
/// Fits with the panel's options: from the muscles as they are, or, if the last step is the panel's own, from those
/// before it, so that it stays one step.
void startFit(EditorState& state);
void cancelFit(EditorState& state);  ///< The muscles stay as they are.
/// Once per frame: takes a finished fit as one undo step. One that began before another edit is dropped.
void followFit(EditorState& state);
[[nodiscard]] bool fitIsCurrent(const EditorState& state);  ///< The last step is the panel's.
void closeFit(EditorState& state);                          ///< Cancels, and keeps what was fitted.

inline constexpr float kLeftRange = 0.01f;  ///< At the ends of the scale, fraction of H.
/// What is left is shown in the picture as displacement: sculpt minus skin.
[[nodiscard]] bool showsLeft(const EditorState& state);
void updateLeft(EditorState& state);  ///< Once per frame, after the surface.

}  // namespace sinew::app
