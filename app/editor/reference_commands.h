// app/editor/reference_commands.h: pictures to work after: from which side, and which file.
#pragma once

#include <filesystem>
#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// Opens the panel, for the side that the camera sees most of, or closes it.
void toggleReferencePanel(EditorState& state);
/// The panel is about this side, and the camera looks from there.
void chooseReferenceSide(EditorState& state, ReferenceSide side);
/// Asks for a picture.
void showReferenceDialog(EditorState& state);
/// For the chosen side; what was set for the picture before stays. @return why it cannot be shown; "" if it is
std::string takeReference(EditorState& state, const std::filesystem::path& file);
void removeReference(EditorState& state);
/// A picture that was dropped on the window: for the side that the panel is about, or for the one that the camera sees
/// most of, whose panel opens.
void dropReference(EditorState& state, const std::filesystem::path& file);

}  // namespace sinew::app
