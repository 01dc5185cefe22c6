// app/editor/symmetry_commands.h: what menus ask for: twins, selecting many, the clipboard.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"
#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

// Muscles as text, for the system's clipboard.
//
// The text is a whole rig file (docs/formats.md) of the copied muscles, their groups and the links between these:
// what is pasted into an editor of text, or saved as a .rig.json, reads as any other rig.

/// With the lines they ride. Links to twins that are not among the copied are left out.
[[nodiscard]] std::string musclesAsText(const Rig& rig, std::span<const int> indices);

struct Pasted {
  Rig rig;
  std::vector<std::string> names;    ///< The new muscles', in order.
  std::vector<std::string> leftOut;  ///< Why each of the others is not there, one line each.
};

/// The rig with what the text holds (core/rig/merge.h: mergeRigs).
/// @param mirror  null, or the plan by which each is pasted on the other side.
/// Error: the text is no rig, holds no muscle, or none could be pasted.
[[nodiscard]] Result<Pasted> pasteText(const Rig& rig, const std::string& text, const Skeleton& skeleton,
                                       const MirrorPlan* mirror);

/// The same on another bone, to which it is moved (moveToBone). What was copied from several bones, from this one, or
/// rides a muscle line, goes where it was.
/// @param plan  null: twins become single muscles.
[[nodiscard]] Result<Pasted> pasteTextOnBone(const Rig& rig, const std::string& text, const Skeleton& skeleton,
                                             int bone, const MirrorPlan* plan);

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
