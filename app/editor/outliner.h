// app/editor/outliner.h: the outliner's rows, and its edits of rig and selection.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"
#include "sinew/character/skeleton.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

enum class RowKind { kBone, kMuscle, kUnattached, kPart };

struct OutlinerRow {
  RowKind kind = RowKind::kBone;
  int index = -1;  ///< Bone or rig index; -1: the node of unattached muscles.
  int level = 0;   ///< Depth in the tree.
  bool foldable = false;
  bool open = false;
  std::string part = {};  ///< kPart: "Left arm" or a group's name.
};

struct OutlinerView {
  std::string filter;            ///< Part of a name, any case; "": all. Shows bones above matches, unfolded.
  bool onlyWithMuscles = false;  ///< Hides bones without a muscle on or below them.
  const std::set<std::string>* folded = nullptr;  ///< Bone paths.
  bool unattachedFolded = false;
  OutlinerOrder order = OutlinerOrder::kBones;
  std::vector<bool> hiddenBones{};  ///< [bones] Hidden without a muscle on or below them; empty: none.
};

/// A sheet is one row, of its first belly. @param boneOf  listedBones()
[[nodiscard]] std::vector<OutlinerRow> outlinerRows(const Rig& rig, const Skeleton& skeleton,
                                                    const std::vector<int>& boneOf, const OutlinerView& view);

/// [bones] "Left arm", "Torso" ...; "Body" if unknown. By name and place in the tree (core/character/joint_roles.h).
[[nodiscard]] std::vector<std::string> bodyParts(const Skeleton& skeleton);

/// A part's key in OutlinerState::folded, unlike any bone's path.
[[nodiscard]] std::string foldedKey(const std::string& part);
/// The row's key (OutlinerState).
[[nodiscard]] std::string keyOf(const OutlinerRow& row, const Rig& rig, const Skeleton& skeleton);
/// Index of a key's row, or -1.
[[nodiscard]] int rowOf(const std::vector<OutlinerRow>& rows, const std::string& key, const Rig& rig,
                        const Skeleton& skeleton);

/// In any case; true for an empty part.
[[nodiscard]] bool containsText(const std::string& text, const std::string& part);

/// Muscles on a bone and below, in rig order. @param boneOf  listedBones()
[[nodiscard]] std::vector<int> musclesUnder(int bone, const Skeleton& skeleton, const std::vector<int>& boneOf);

inline constexpr const char* kMusclePayload =
    "sinew.muscles";  ///< Drag and drop: rig index (int) of the grabbed muscle.

/// Moves muscles to another bone, keeping their places in the shown pose; sheets stay. One undo step, or a refusal.
void reparentMuscles(EditorState& state, const std::vector<int>& muscles, int bone);

/// A click on a muscle's row. @param range  Shift: from the anchor to here  @param toggle  Ctrl
void clickMuscle(EditorState& state, const std::vector<OutlinerRow>& rows, int position, bool range, bool toggle);
void clickBone(EditorState& state, int bone);  ///< A click on a bone's row: selects it; in territory mode toggles it.
/// Up and down among the rows. @param extend  Shift: adds muscles on the way
void moveCursor(EditorState& state, const std::vector<OutlinerRow>& rows, int by, bool extend);

void selectMuscles(Document& document, const std::vector<int>& indices);
/// Folds or unfolds a bone's row. @param all  and those below
void setFolded(EditorState& state, int bone, bool folded, bool all);
void unfoldTo(EditorState& state, int bone);       ///< Unfolds down to a bone's row.
void unfoldParts(EditorState& state, int muscle);  ///< Unfolds its parts in the flat lists. @param muscle  rig index
void setPartFolded(EditorState& state, const std::string& part, bool folded);

}  // namespace sinew::app
