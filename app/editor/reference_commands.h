// app/editor/reference_commands.h: reference pictures for each side.
#pragma once

#include <filesystem>
#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

void toggleReferencePanel(EditorState& state);  ///< Opens the panel for the side that faces the camera, or closes it.
void chooseReferenceSide(EditorState& state, ReferenceSide side);  ///< Shows this side in the panel and to the camera.
void showReferenceDialog(EditorState& state);
/// Sets the chosen side's picture and keeps its settings. @return why it cannot be shown, or ""
std::string takeReference(EditorState& state, const std::filesystem::path& file);
void removeReference(EditorState& state);
/// Takes a dropped picture for the panel's side; opens the panel if needed.
void dropReference(EditorState& state, const std::filesystem::path& file);

}  // namespace sinew::app
