// app/editor/outliner.h: what the outliner does to rig and selection.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"
#include "sinew/character/skeleton.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

// The bones as a tree with their muscles under them, as a flat list of rows.

enum class RowKind { kBone, kMuscle, kUnattached, kPart };

struct OutlinerRow {
  RowKind kind = RowKind::kBone;
  int index = -1;  ///< Bone or rig index; -1: the node that holds what is unattached.
  int level = 0;   ///< Depth in the tree.
  bool foldable = false;
  bool open = false;
  std::string part = {};  ///< Of kPart: its title, "Left arm" or a group's name.
};

/// What the tree shows.
struct OutlinerView {
  std::string filter;            ///< Part of a name, any case; "": all. Matches keep the bones above, and all unfolds.
  bool onlyWithMuscles = false;  ///< Leaves out bones with no muscle on or below them.
  const std::set<std::string>* folded = nullptr;  ///< Bone paths.
  bool unattachedFolded = false;
  OutlinerOrder order = OutlinerOrder::kBones;
  std::vector<bool> hiddenBones{};  ///< [bones] left out, unless a muscle is on or below them; empty: none.
};

/// @param boneOf  [primitives] bone index, -1: unattached
[[nodiscard]] std::vector<OutlinerRow> outlinerRows(const Rig& rig, const Skeleton& skeleton,
                                                    const std::vector<int>& boneOf, const OutlinerView& view);

/// [bones] "Left arm", "Torso", "Head and neck" ...: the part of the body that each bone moves, by its name and its
/// place in the tree (core/character/joint_roles.h); "Body" where nothing is known.
[[nodiscard]] std::vector<std::string> bodyParts(const Skeleton& skeleton);

/// What OutlinerState::folded has of a part; no bone's path begins so.
[[nodiscard]] std::string foldedKey(const std::string& part);
/// The row's key (OutlinerState).
[[nodiscard]] std::string keyOf(const OutlinerRow& row, const Rig& rig, const Skeleton& skeleton);
/// Position of a key, or -1.
[[nodiscard]] int rowOf(const std::vector<OutlinerRow>& rows, const std::string& key, const Rig& rig,
                        const Skeleton& skeleton);

/// Any case, in any place; true for an empty part.
[[nodiscard]] bool containsText(const std::string& text, const std::string& part);

/// Muscles on a bone and on those below it, rig order.
[[nodiscard]] std::vector<int> musclesUnder(int bone, const Skeleton& skeleton, const std::vector<int>& boneOf);

inline constexpr const char* kMusclePayload = "sinew.muscles";  ///< Drag and drop: the grabbed muscle's rig index, int.

/// Moves muscles to another bone; each keeps its place in the world at the moment that is shown. One undo step;
/// a refusal is said as refuse() does.
void reparentMuscles(EditorState& state, const std::vector<int>& indices, int bone);

/// A click on a muscle's row. @param range  Shift: all from the anchor to here; @param toggle  Ctrl.
void clickMuscle(EditorState& state, const std::vector<OutlinerRow>& rows, int position, bool range, bool toggle);
/// A click on a bone's row: selects it, or in territory mode lets it join or leave.
void clickBone(EditorState& state, int bone);
/// Up and down among the rows. @param extend  Shift: muscles on the way are added.
void moveCursor(EditorState& state, const std::vector<OutlinerRow>& rows, int by, bool extend);

void selectMuscles(Document& document, const std::vector<int>& indices);
/// Closes or opens a bone's row. @param all  those below it too
void setFolded(EditorState& state, int bone, bool folded, bool all);
/// Opens what hides a muscle's row.
void unfoldTo(EditorState& state, int bone);
/// The same in the flat lists. @param muscle  rig index
void unfoldParts(EditorState& state, int muscle);
/// Closes or opens a part of a flat list.
void setPartFolded(EditorState& state, const std::string& part, bool folded);

}  // namespace sinew::app
