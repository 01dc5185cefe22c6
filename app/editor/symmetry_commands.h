// app/editor/symmetry_commands.h: what menus ask for: twins, selecting many, the clipboard.
#pragma once

#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

// Symmetry. What cannot be mirrored is reported in the messages.
[[nodiscard]] bool canMirror(const Document& document);  ///< The character has pairs of bones, or bones in its plane.
void toggleSymmetry(Document& document);
void mirrorSelection(EditorState& state);  ///< A linked twin for each selected muscle; twins become exact again.
void flipSelection(EditorState& state);    ///< To the other side, link and name kept.
void unlinkSelection(EditorState& state);
void linkSelection(EditorState& state);  ///< Two selected: the first picked becomes the image of the active one.
void selectTwins(Document& document);    ///< Instead of the selected ones.
[[nodiscard]] bool anyTwin(const Document& document);  ///< A selected muscle has a twin.
[[nodiscard]] bool twoSelected(const Document& document);
/// Why the active muscle's twin cannot follow it at the moment; "" if it can, or has none.
[[nodiscard]] std::string whyTwinStays(const Document& document);

// Selection. Hidden and locked muscles are left out.
void selectAll(Document& document);
void invertSelection(Document& document);
void selectOnBone(Document& document);  ///< All muscles on the bones of the selected ones, or on the selected bone.

// Clipboard, through ImGui.
void copySelection(Document& document);
void cutSelection(EditorState& state);
void pasteMuscles(EditorState& state, bool mirrored);

/// The selected muscles, with their twins while symmetry is on: what is deleted, copied or duplicated. Ascending.
[[nodiscard]] std::vector<int> editedIndices(const Document& document);

}  // namespace sinew::app
