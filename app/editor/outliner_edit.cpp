// app/editor/outliner_edit.cpp: what the outliner does to rig and selection.

#include "app/editor/outliner_edit.h"

#include <algorithm>
#include <utility>

#include "app/document/muscle_names.h"
#include "app/document/shown_names.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/territory.h"
#include "core/geometry/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

/// The row that the keyboard stands on: of the active muscle, else of the bone.
int cursorRow(const Document& document, const std::vector<OutlinerRow>& rows) {
  const int active = document.activePrimitive();
  const int bone = document.selection.bone;
  const auto found = std::ranges::find_if(rows, [&](const OutlinerRow& row) {
    return active >= 0 ? row.kind == RowKind::kMuscle && row.index == active
                       : row.kind == RowKind::kBone && row.index == bone;
  });
  return found == rows.end() ? -1 : static_cast<int>(found - rows.begin());
}

/// Muscles between two rows, the one of `to` last, so that it is the active one.
std::vector<PrimitiveId> musclesBetween(const Document& document, const std::vector<OutlinerRow>& rows, int from,
                                        int to) {
  std::vector<PrimitiveId> muscles;
  const int step = from <= to ? 1 : -1;
  for (int position = from; position != to + step; position += step) {
    const OutlinerRow& row = at(rows, position);
    if (row.kind == RowKind::kMuscle) muscles.push_back(document.idAt(row.index));
  }
  return muscles;
}

}  // namespace

void reparentMuscles(EditorState& state, const std::vector<int>& indices, int bone) {
  const auto rig = state.document.commands.sharedRig();
  const Skeleton& skeleton = state.character().skeleton;
  const auto& matrices = state.live->pose().boneInWorld;
  const std::string target = skeleton.fileName(bone);
  Result<Rig> moved = editPrimitives(*rig, indices, [&](Primitive& primitive) {
    const std::optional<int> from = skeleton.findBone(primitive.bone);
    if (from == bone) return;
    if (from) {
      // On a line the bone is only what placements are measured in, in the bind pose.
      const auto matrixOf = [&](int of) {
        const auto i = static_cast<std::size_t>(of);
        return primitive.line.empty() ? matrices[i] : skeleton.bones[i].bindInWorld;
      };
      primitive.placement = carryToBone(primitive.placement, matrixOf(*from), matrixOf(bone));
    }
    primitive.bone = target;
  });
  if (moved) moved = withDefaultNames(*rig, std::move(moved).value(), skeleton);
  edit(state, "Move " + namedMuscles(*rig, indices) + " to " + shownBoneName(skeleton, bone), std::move(moved));
}

void clickMuscle(EditorState& state, const std::vector<OutlinerRow>& rows, int position, bool range, bool toggle) {
  const Rig& rig = state.document.rig();
  const Skeleton& skeleton = state.character().skeleton;
  const OutlinerRow& row = at(rows, position);
  if (static_cast<std::size_t>(row.index) >= rig.primitives.size()) return;
  Selection& selection = state.document.selection;
  const int anchor = range ? rowOf(rows, state.open.rowAnchor, rig, skeleton) : -1;
  if (anchor >= 0) {
    selection.setAll(musclesBetween(state.document, rows, anchor, position), toggle);
    return;
  }
  const PrimitiveId muscle = state.document.idAt(row.index);
  if (toggle || range) {
    selection.toggle(muscle);
  } else {
    selection.set(muscle);
  }
  state.open.rowAnchor = keyOf(row, rig, skeleton);
}

void clickBone(EditorState& state, int bone) {
  if (editsTerritory(state)) {
    toggleTerritoryBone(state, bone);
    return;
  }
  state.document.selection.primitives.clear();
  state.document.selection.bone = bone;
  state.open.rowAnchor = "b:" + at(state.character().skeleton.bones, bone).path;
}

void moveCursor(EditorState& state, const std::vector<OutlinerRow>& rows, int by, bool extend) {
  const int count = static_cast<int>(rows.size());
  const int from = cursorRow(state.document, rows);
  int to = from < 0 ? (by > 0 ? 0 : count - 1) : from + by;
  // Titles cannot be selected.
  const auto isTitle = [&](int row) {
    return row >= 0 && row < count &&
           (at(rows, row).kind == RowKind::kUnattached || at(rows, row).kind == RowKind::kPart);
  };
  while (isTitle(to)) to += by > 0 ? 1 : -1;
  if (to < 0 || to >= count) return;
  const OutlinerRow& row = at(rows, to);
  if (row.kind == RowKind::kMuscle) {
    clickMuscle(state, rows, to, extend, false);
  } else if (!extend) {
    state.document.selection.primitives.clear();
    state.document.selection.bone = row.index;
    state.open.rowAnchor = keyOf(row, state.document.rig(), state.character().skeleton);
  }
}

void selectMuscles(Document& document, const std::vector<int>& indices) {
  document.selection.primitives.clear();
  for (const int index : indices) document.selection.primitives.push_back(document.idAt(index));
}

void setFolded(EditorState& state, int bone, bool folded, bool all) {
  const Skeleton& skeleton = state.character().skeleton;
  const Bone& own = at(skeleton.bones, bone);
  std::set<std::string>& paths = state.view.outliner.folded;
  if (folded) {
    paths.insert(own.path);
  } else {
    paths.erase(own.path);
  }
  if (!all) return;
  for (const int child : own.children) setFolded(state, child, folded, true);
}

void unfoldTo(EditorState& state, int bone) {
  const Skeleton& skeleton = state.character().skeleton;
  for (int b = bone; b >= 0; b = at(skeleton.bones, b).parent) {
    state.view.outliner.folded.erase(at(skeleton.bones, b).path);
  }
}

void unfoldParts(EditorState& state, int muscle) {
  const Primitive& primitive = at(state.document.rig().primitives, muscle);
  const Skeleton& skeleton = state.character().skeleton;
  state.view.outliner.folded.erase(foldedKey(primitive.group));
  const std::optional<int> bone = skeleton.findBone(primitive.bone);
  if (!bone) return;
  const std::vector<std::string> parts = bodyParts(skeleton);
  state.view.outliner.folded.erase(foldedKey(at(parts, *bone)));
}

void setPartFolded(EditorState& state, const std::string& part, bool folded) {
  if (folded) state.view.outliner.folded.insert(foldedKey(part));
  else state.view.outliner.folded.erase(foldedKey(part));
}

}  // namespace sinew::app
