// app/editor/outliner_rows.cpp: the tree as a flat list of rows.

#include "app/editor/outliner_rows.h"

#include <algorithm>

#include "core/base/lower_case.h"

#include "core/base/at.h"

namespace sinew::app {
namespace {

struct Walk {
  const Rig& rig;
  const Skeleton& skeleton;
  const OutlinerView& view;
  std::vector<std::vector<int>> musclesOfBone;
  std::vector<int> unattached;
  std::vector<bool> shown;    ///< [bones]
  std::vector<bool> matches;  ///< [bones] Its own name does: then all its muscles are shown.
  std::vector<OutlinerRow> rows;

  [[nodiscard]] bool filtered() const { return !view.filter.empty(); }
  [[nodiscard]] bool muscleShown(int muscle, bool boneMatches) const {
    return boneMatches || containsText(at(rig.primitives, muscle).name, view.filter);
  }
  [[nodiscard]] bool foldedAway(const std::string& path) const {
    return !filtered() && view.folded != nullptr && view.folded->contains(path);
  }
};

void sortMuscles(Walk& walk, const std::vector<int>& boneOf) {
  walk.musclesOfBone.resize(walk.skeleton.bones.size());
  for (std::size_t i = 0; i < boneOf.size(); ++i) {
    auto& list = boneOf[i] >= 0 ? at(walk.musclesOfBone, boneOf[i]) : walk.unattached;
    list.push_back(static_cast<int>(i));
  }
}

/// Children stand behind their parents, so one pass from the end sees every child before its parent.
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

}  // namespace

bool containsText(const std::string& text, const std::string& part) {
  if (part.empty()) return true;
  return !std::ranges::search(text, part, {}, toLower, toLower).empty();
}

std::vector<OutlinerRow> outlinerRows(const Rig& rig, const Skeleton& skeleton, const std::vector<int>& boneOf,
                                      const OutlinerView& view) {
  Walk walk{rig, skeleton, view, {}, {}, {}, {}, {}};
  sortMuscles(walk, boneOf);
  markShown(walk);
  addUnattached(walk);
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    if (skeleton.bones[b].parent < 0) addBone(walk, static_cast<int>(b), 0);
  }
  return std::move(walk.rows);
}

std::string keyOf(const OutlinerRow& row, const Rig& rig, const Skeleton& skeleton) {
  if (row.kind == RowKind::kUnattached) return "u:";
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

}  // namespace sinew::app
