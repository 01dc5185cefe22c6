// app/editor/symmetry_commands.h: twins, selecting many muscles, and the clipboard.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"
#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

// Muscles as text: a rig file (docs/formats.md) of the copied muscles with their lines, groups and links.

/// Drops links to twins that are not copied.
[[nodiscard]] std::string musclesAsText(const Rig& rig, std::span<const int> indices);

struct Pasted {
  Rig rig;
  std::vector<std::string> names;    ///< Of the new muscles, in order.
  std::vector<std::string> sheets;   ///< Of the new sheets.
  std::vector<std::string> leftOut;  ///< A line for each muscle that was not pasted.
};

/// By mergeRigs (core/rig/merge.h). @param mirror  null, or the plan for the other side. Error: nothing can be pasted.
[[nodiscard]] Result<Pasted> pasteText(const Rig& rig, const std::string& text, const Skeleton& skeleton,
                                       const MirrorPlan* mirror);

/// The same moved to another bone (moveToBone), unless the muscles are from several bones, from this one, or on a line.
/// @param plan  null: twins become single muscles
[[nodiscard]] Result<Pasted> pasteTextOnBone(const Rig& rig, const std::string& text, const Skeleton& skeleton,
                                             int bone, const MirrorPlan* plan);

// Symmetry. Messages name what cannot be mirrored.
[[nodiscard]] bool canMirror(const Document& document);  ///< The character has pairs of bones, or bones in its plane.
void toggleSymmetry(Document& document);
void mirrorSelection(EditorState& state);  ///< Gives each selected muscle an exact linked twin.
void flipSelection(EditorState& state);    ///< To the other side, keeping link and name.
void unlinkSelection(EditorState& state);
void linkSelection(EditorState& state);                ///< The first of two selected mirrors the active one.
void selectTwins(Document& document);                  ///< In place of the selection.
[[nodiscard]] bool anyTwin(const Document& document);  ///< A selected muscle has a twin.
[[nodiscard]] bool twoSelected(const Document& document);
/// Why the active muscle's twin cannot follow it; "" if it can, or without a twin.
[[nodiscard]] std::string whyTwinStays(const Document& document);

// Selection, without hidden and locked muscles.
void selectAll(Document& document);
void invertSelection(Document& document);
void selectOnBone(Document& document);  ///< On the bones of the selected muscles, or on the selected bone.

// Clipboard, through ImGui.
void copySelection(Document& document);
void cutSelection(EditorState& state);
void pasteMuscles(EditorState& state, bool mirrored);

/// Muscles to delete, copy or duplicate: the selected ones, with symmetry also their twins. Ascending.
[[nodiscard]] std::vector<int> editedIndices(const Document& document);

}  // namespace sinew::app
