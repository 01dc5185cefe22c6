// app/editor/locate_character.h: a rig whose character is not where the rig says opens with one that the user
// names.
#pragma once

#include <filesystem>
#include <string>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// From the question (Dialogs::locate) to the file dialog: at the rig's folder, with the file of the missing one's name
/// if there is one.
void showLocateDialog(EditorState& state);

/// The rig with this character; the path to it is an unsaved change. @return an empty text, or why it failed: then the
/// open document stays.
std::string openWithCharacter(EditorState& state, const std::filesystem::path& rigFile,
                              const std::filesystem::path& characterFile);

}  // namespace sinew::app
