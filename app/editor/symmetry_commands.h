// app/editor/symmetry_commands.h: what menus ask for: twins, selecting many, the clipboard.
#pragma once

#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

// Symmetry. What cannot be mirrored is reported in the messages.
[[nodiscard]] bool canMirror(const EditorState& state);  ///< The character has pairs of bones, or bones in its plane.
void toggleSymmetry(EditorState& state);
void mirrorSelection(EditorState& state);  ///< A linked twin for each selected muscle; twins become exact again.
void flipSelection(EditorState& state);    ///< To the other side, link and name kept.
void unlinkSelection(EditorState& state);
void linkSelection(EditorState& state);  ///< Two selected: the first picked becomes the image of the active one.
void selectTwins(EditorState& state);    ///< Instead of the selected ones.
[[nodiscard]] bool anyTwin(const EditorState& state);  ///< A selected muscle has a twin.
[[nodiscard]] bool twoSelected(const EditorState& state);
/// Why the active muscle's twin cannot follow it at the moment; "" if it can, or has none.
[[nodiscard]] std::string whyTwinStays(const EditorState& state);

// Selection. Hidden and locked muscles are left out.
void selectAll(EditorState& state);
void invertSelection(EditorState& state);
void selectOnBone(EditorState& state);  ///< All muscles on the bones of the selected ones, or on the selected bone.

// Clipboard, through ImGui.
void copySelection(EditorState& state);
void cutSelection(EditorState& state);
void pasteMuscles(EditorState& state, bool mirrored);

/// The selected muscles, with their twins while symmetry is on: what is deleted, copied or duplicated. Ascending.
[[nodiscard]] std::vector<int> editedIndices(const EditorState& state);

}  // namespace sinew::app
