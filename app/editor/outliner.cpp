// app/editor/outliner.cpp: the outliner's rows, and its edits of rig and selection.
#include "app/editor/outliner.h"

#include <algorithm>
#include <utility>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "core/character/bone_names.h"
#include "core/character/joint_roles.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/line_edit.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {

namespace {

struct Walk {
  const Rig& rig;
  const Skeleton& skeleton;
  const OutlinerView& view;
  std::vector<std::vector<int>> musclesOfBone;
  std::vector<int> unattached;
  std::vector<bool> shown;    ///< [bones]
  std::vector<bool> matches;  ///< [bones] The name matches: all its muscles are shown.
  std::vector<OutlinerRow> rows;

  [[nodiscard]] bool filtered() const { return !view.filter.empty(); }
  [[nodiscard]] bool muscleShown(int muscle, bool boneMatches) const {
    return boneMatches || containsText(muscleName(rig, muscle), view.filter);
  }
  [[nodiscard]] bool foldedAway(const std::string& path) const {
    return !filtered() && view.folded != nullptr && view.folded->contains(path);
  }
};

void sortMuscles(Walk& walk, const std::vector<int>& boneOf) {
  walk.musclesOfBone.resize(walk.skeleton.bones.size());
  for (const int lead : allLeads(walk.rig)) {
    const int bone = at(boneOf, lead);
    auto& list = bone >= 0 ? at(walk.musclesOfBone, bone) : walk.unattached;
    list.push_back(lead);
  }
}

/// One pass from the end sees children before their parents.
void markShown(Walk& walk) {
  const std::size_t count = walk.skeleton.bones.size();
  walk.shown.assign(count, false);
  walk.matches.assign(count, false);
  for (std::size_t b = count; b-- > 0;) {
    const Bone& bone = walk.skeleton.bones[b];
    walk.matches[b] = !walk.filtered() || containsText(bone.name, walk.view.filter);
    const bool muscle =
        std::ranges::any_of(walk.musclesOfBone[b], [&](int i) { return walk.muscleShown(i, walk.matches[b]); });
    const bool hidden = !walk.view.hiddenBones.empty() && walk.view.hiddenBones[b];
    if (muscle || (walk.matches[b] && !walk.view.onlyWithMuscles && !hidden)) walk.shown[b] = true;
    if (walk.shown[b] && bone.parent >= 0) at(walk.shown, bone.parent) = true;
  }
}

void addBone(Walk& walk, int index, int level) {
  const auto b = static_cast<std::size_t>(index);
  if (!walk.shown[b]) return;
  const Bone& bone = walk.skeleton.bones[b];
  OutlinerRow row{RowKind::kBone, index, level, false, !walk.foldedAway(bone.path)};
  row.foldable =
      !walk.musclesOfBone[b].empty() || std::ranges::any_of(bone.children, [&](int c) { return at(walk.shown, c); });
  walk.rows.push_back(row);
  if (!row.open) return;
  for (const int muscle : walk.musclesOfBone[b]) {
    if (walk.muscleShown(muscle, walk.matches[b])) walk.rows.push_back({RowKind::kMuscle, muscle, level + 1});
  }
  for (const int child : bone.children) addBone(walk, child, level + 1);
}

void addUnattached(Walk& walk) {
  std::vector<int> shown = walk.unattached;
  std::erase_if(shown, [&](int muscle) {
    const Primitive& primitive = at(walk.rig.primitives, muscle);
    return !walk.muscleShown(muscle, containsText(primitive.bone, walk.view.filter));
  });
  if (shown.empty()) return;
  const bool open = walk.filtered() || !walk.view.unattachedFolded;
  walk.rows.push_back({RowKind::kUnattached, -1, 0, true, open});
  if (!open) return;
  for (const int muscle : shown) walk.rows.push_back({RowKind::kMuscle, muscle, 1});
}

/// Parts in listing order.
std::vector<std::string> partsInOrder(const Walk& walk, const std::vector<std::string>& partOf) {
  std::vector<std::string> parts;
  if (walk.view.order == OutlinerOrder::kGroups) {
    for (const Group& group : walk.rig.groups) parts.push_back(group.name);
    return parts;
  }
  for (const std::string& part : partOf) {
    if (!part.empty() && std::ranges::find(parts, part) == parts.end()) parts.push_back(part);
  }
  std::ranges::sort(parts);
  return parts;
}

/// A flat list: each part's muscles by name.
void addParts(Walk& walk, const std::vector<int>& boneOf) {
  const bool byGroup = walk.view.order == OutlinerOrder::kGroups;
  const std::vector<std::string> ofBones = byGroup ? std::vector<std::string>() : bodyParts(walk.skeleton);
  const std::vector<int> leads = allLeads(walk.rig);
  std::vector<std::string> partOf(leads.size());
  for (std::size_t i = 0; i < leads.size(); ++i) {
    const int bone = at(boneOf, leads[i]);
    if (byGroup) partOf[i] = at(walk.rig.primitives, leads[i]).group;
    else if (bone >= 0) partOf[i] = at(ofBones, bone);
  }
  for (const std::string& part : partsInOrder(walk, partOf)) {
    std::vector<int> muscles;
    for (std::size_t i = 0; i < partOf.size(); ++i) {
      const bool asked = walk.muscleShown(leads[i], walk.filtered() && containsText(part, walk.view.filter));
      if (partOf[i] == part && asked) muscles.push_back(leads[i]);
    }
    if (muscles.empty()) continue;
    std::ranges::stable_sort(muscles, {}, [&](int i) { return muscleName(walk.rig, i); });
    const bool open = !walk.foldedAway(foldedKey(part));
    walk.rows.push_back({RowKind::kPart, -1, 0, true, open, part});
    if (!open) continue;
    for (const int muscle : muscles) walk.rows.push_back({RowKind::kMuscle, muscle, 1});
  }
}

const char* partWord(JointRole role) {
  switch (role) {
    case JointRole::kNeck:
      return "head and neck";
    case JointRole::kTail:
      return "tail";
    case JointRole::kCollar:
    case JointRole::kShoulder:
    case JointRole::kElbow:
    case JointRole::kWrist:
      return "arm";
    case JointRole::kHip:
    case JointRole::kKnee:
    case JointRole::kAnkle:
      return "leg";
    case JointRole::kTrunk:
    case JointRole::kStill:
      return "torso";
    case JointRole::kDigit:
    case JointRole::kFree:
      break;
  }
  return "";
}

}  // namespace

std::vector<std::string> bodyParts(const Skeleton& skeleton) {
  const std::vector<JointRole> roles = jointRoles(skeleton);
  const std::vector<BoneName> names = boneNames(skeleton);
  std::vector<std::string> words(skeleton.bones.size());
  std::vector<std::string> parts;
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    words[b] = partWord(roles[b]);
    // Fingers and unknown bones belong to their parent's part.
    const int parent = skeleton.bones[b].parent;
    if (words[b].empty()) words[b] = parent >= 0 ? at(words, parent) : "body";
    const std::optional<Side> side = names[b].side;
    std::string part = words[b];
    if (words[b] == "arm" || words[b] == "leg") {
      if (side == Side::kLeft) part = "left " + part;
      if (side == Side::kRight) part = "right " + part;
      const std::string& above = parent >= 0 ? at(parts, parent) : part;
      if (!side && parent >= 0 && at(words, parent) == words[b]) part = above;
    }
    parts.push_back(std::move(part));
  }
  for (std::string& part : parts) {
    if (part.front() >= 'a' && part.front() <= 'z') part.front() = static_cast<char>(part.front() - 'a' + 'A');
  }
  return parts;
}

std::string foldedKey(const std::string& part) { return "part:" + part; }

bool containsText(const std::string& text, const std::string& part) {
  if (part.empty()) return true;
  return !std::ranges::search(text, part, {}, toLower, toLower).empty();
}

std::vector<OutlinerRow> outlinerRows(const Rig& rig, const Skeleton& skeleton, const std::vector<int>& boneOf,
                                      const OutlinerView& view) {
  Walk walk{rig, skeleton, view, {}, {}, {}, {}, {}};
  sortMuscles(walk, boneOf);
  markShown(walk);
  if (view.order != OutlinerOrder::kGroups) addUnattached(walk);
  if (view.order != OutlinerOrder::kBones) {
    addParts(walk, boneOf);
    return std::move(walk.rows);
  }
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    if (skeleton.bones[b].parent < 0) addBone(walk, static_cast<int>(b), 0);
  }
  return std::move(walk.rows);
}

std::string keyOf(const OutlinerRow& row, const Rig& rig, const Skeleton& skeleton) {
  if (row.kind == RowKind::kUnattached) return "u:";
  if (row.kind == RowKind::kPart) return "p:" + row.part;
  const auto index = static_cast<std::size_t>(row.index);
  return row.kind == RowKind::kMuscle ? "m:" + std::to_string(rig.primitives[index].id().value)
                                      : "b:" + skeleton.bones[index].path;
}

int rowOf(const std::vector<OutlinerRow>& rows, const std::string& key, const Rig& rig, const Skeleton& skeleton) {
  const auto found =
      std::ranges::find_if(rows, [&](const OutlinerRow& row) { return keyOf(row, rig, skeleton) == key; });
  return found == rows.end() ? -1 : static_cast<int>(found - rows.begin());
}

std::vector<int> musclesUnder(int bone, const Skeleton& skeleton, const std::vector<int>& boneOf) {
  std::vector<bool> below(skeleton.bones.size(), false);
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const int parent = skeleton.bones[b].parent;
    below[b] = static_cast<int>(b) == bone || (parent >= 0 && at(below, parent));
  }
  std::vector<int> muscles;
  for (std::size_t i = 0; i < boneOf.size(); ++i) {
    if (boneOf[i] >= 0 && at(below, boneOf[i])) muscles.push_back(static_cast<int>(i));
  }
  return muscles;
}

namespace {

/// Row of the active muscle, else of the selected bone, or -1.
int cursorRow(const Document& document, const std::vector<OutlinerRow>& rows) {
  const int active = document.activePrimitive();
  const int bone = document.selection.bone;
  const auto found = std::ranges::find_if(rows, [&](const OutlinerRow& row) {
    return active >= 0 ? row.kind == RowKind::kMuscle && row.index == active
                       : row.kind == RowKind::kBone && row.index == bone;
  });
  return found == rows.end() ? -1 : static_cast<int>(found - rows.begin());
}

/// Muscles between two rows, that of `to` last, which makes it active.
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

void fold(EditorState& state, const std::string& key, bool folded) {
  if (folded) state.view.outliner.folded.insert(key);
  else state.view.outliner.folded.erase(key);
}

}  // namespace

void reparentMuscles(EditorState& state, const std::vector<int>& muscles, int bone) {
  const auto rig = state.document.commands.sharedRig();
  const std::vector<int> indices = withoutSheets(*rig, muscles);
  if (indices.empty()) return sayRefusal(state, "A sheet follows the bones of its edges: drag their points");
  const Skeleton& skeleton = state.character().skeleton;
  const auto& matrices = state.live->pose().boneInWorld;
  const std::string target = skeleton.fileName(bone);
  Result<Rig> moved = editPrimitives(*rig, indices, [&](Primitive& primitive) {
    const std::optional<int> from = skeleton.findBone(primitive.bone);
    if (from == bone) return;
    if (from) {
      // On a line, placements are relative to the bone in the bind pose.
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
    return completeSheets(state.document);
  }
  if (toggle || range) toggleMuscle(state.document, row.index);
  else selectMuscle(state.document, row.index);
  state.open.rowAnchor = keyOf(row, rig, skeleton);
}

void clickBone(EditorState& state, int bone) {
  if (editsTerritory(state)) return toggleTerritoryBone(state, bone);
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
  completeSheets(document);
}

void setFolded(EditorState& state, int bone, bool folded, bool all) {
  const Skeleton& skeleton = state.character().skeleton;
  const Bone& own = at(skeleton.bones, bone);
  fold(state, own.path, folded);
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
  const std::optional<int> bone = skeleton.findBone(listedBone(state.document.rig(), muscle));
  if (!bone) return;
  const std::vector<std::string> parts = bodyParts(skeleton);
  state.view.outliner.folded.erase(foldedKey(at(parts, *bone)));
}

void setPartFolded(EditorState& state, const std::string& part, bool folded) { fold(state, foldedKey(part), folded); }

}  // namespace sinew::app
