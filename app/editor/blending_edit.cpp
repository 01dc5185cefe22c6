// app/editor/blending_edit.cpp: edits of groups, links and territories.

#include "app/editor/blending_edit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/viewport/render/color_scales.h"
#include "app/viewport/tools/viewport_tools.h"
#include "core/geometry/at.h"
#include "core/rig/attachment.h"
#include "core/rig/rig_edit.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {

namespace {

/// Rig index of the mode's muscle, or -1.
int subject(const EditorState& state) {
  return state.hasCharacter() && state.view.tools.territoryMode ? territorySubject(state.document) : -1;
}

int boneOf(const EditorState& state, int index) {
  const Primitive& primitive = at(state.document.rig().primitives, index);
  return state.character().skeleton.findBone(primitive.bone).value_or(-1);
}

}  // namespace

bool editsTerritory(const EditorState& state) { return subject(state) >= 0; }

void toggleTerritoryMode(EditorState& state) {
  state.view.tools.territoryMode = !editsTerritory(state) && territorySubject(state.document) >= 0;
}

void endTerritoryMode(ViewportTools& tools) { tools.territoryMode = false; }

Result<Rig> withDefaultTerritory(const Rig& rig, const std::vector<int>& indices) {
  return editPrimitives(rig, indices, [](Primitive& primitive) { primitive.territory.reset(); });
}

void toggleTerritoryBone(EditorState& state, int bone) {
  const Result<void> done = toggleTerritoryBone(state.document, bone);
  if (done) state.open.refusal.clear();
  else refuse(state, done.error());
}

std::vector<int> shownTerritory(const EditorState& state) {
  const int index = subject(state);
  if (index < 0) return {};
  const int bone = boneOf(state, index);
  if (bone < 0) return {};
  const Primitive& primitive = at(state.document.rig().primitives, index);
  return territoryBones(primitive, bone, lineOf(state.document.rig(), primitive), state.character().skeleton);
}

std::vector<float> shownTerritoryWeights(const EditorState& state) {
  const std::vector<int> bones = shownTerritory(state);
  std::vector<float> weights;
  if (bones.empty()) return weights;
  std::vector<bool> within(state.character().skeleton.bones.size(), false);
  for (const int bone : bones) at(within, bone) = true;
  const std::size_t count = state.character().mesh.positions.size();
  weights.reserve(count);
  for (std::size_t v = 0; v < count; ++v) {
    weights.push_back(territoryWeight(state.character(), static_cast<int>(v), within));
  }
  return weights;
}

namespace {

Tint tintOf(const glm::vec3& color) { return {color.r, color.g, color.b}; }

const std::string& nameOfGroup(const Rig& rig, int group) { return at(rig.groups, group).name; }

}  // namespace

Tint groupTint(const Rig& rig, int group) {
  return group < 0 ? palette::kMuted : tintOf(groupColor(colorSlot(rig, group)));
}

Tint groupTint(const Rig& rig, const std::string& group) { return groupTint(rig, findGroup(rig, group)); }

Tint animationTint(const Link& link) {
  const auto isDriven = [](const AnimatedNumber& number) { return !number.drivers.empty(); };
  return std::ranges::any_of(link.animated, isDriven) ? palette::kDriven : palette::kKeyed;
}

Tint territoryTint() { return tintOf(kTerritoryColor); }

std::vector<std::vector<float>> linkTable(const Rig& rig) {
  std::vector<std::vector<float>> table(rig.groups.size(), std::vector<float>(rig.groups.size(), 0.0f));
  for (const Link& link : rig.links) {
    const int i = findGroup(rig, link.groups[0]);
    const int j = findGroup(rig, link.groups[1]);
    if (i < 0 || j < 0) continue;
    const float most = std::max(at(at(table, i), j), link.amount);
    at(at(table, i), j) = at(at(table, j), i) = most;
  }
  return table;
}

std::string percentText(float amount) { return std::to_string(std::lround(100.0f * amount)) + " %"; }

std::string linkLabel(const Rig& rig, int groupA, int groupB, float amount) {
  const std::string both = nameOfGroup(rig, groupA) + " and " + nameOfGroup(rig, groupB);
  if (amount == 0.0f) return "Unlink " + both;
  return "Link " + both + (amount < 1.0f ? " by " + percentText(amount) : "");
}

void toggleLink(EditorState& state, int groupA, int groupB) {
  const Rig& rig = state.document.rig();
  const bool linked = linkAmount(rig, nameOfGroup(rig, groupA), nameOfGroup(rig, groupB)) > 0.0f;
  const float amount = linked ? 0.0f : 1.0f;
  edit(state, linkLabel(rig, groupA, groupB, amount), setLink(rig, groupA, groupB, amount));
}

const Link* animatedLink(const Rig& rig, int groupA, int groupB) {
  const int link = findLink(rig, nameOfGroup(rig, groupA), nameOfGroup(rig, groupB));
  return link < 0 || at(rig.links, link).animated.empty() ? nullptr : &at(rig.links, link);
}

void setLinkAmount(EditorState& state, int groupA, int groupB, float amount) {
  const Rig& rig = state.document.rig();
  const float least = animatedLink(rig, groupA, groupB) ? 0.01f : 0.0f;
  const float rounded = std::round(100.0f * std::clamp(amount, least, 1.0f)) / 100.0f;
  edit(state, linkLabel(rig, groupA, groupB, rounded), setLink(rig, groupA, groupB, rounded));
}

void addEmptyGroup(EditorState& state) {
  const std::string name = freeGroupName(state.document.rig(), "group");
  if (!edit(state, "New group", addGroup(state.document.rig(), name))) return;
  const GroupId added = state.document.rig().groups.back().id();
  state.open.blending.group = added;
  state.open.blending.rename = {added, name, true};
}

void groupSelection(EditorState& state) {
  const std::vector<int> indices = selectedIndices(state.document);
  if (indices.empty()) return;
  const std::string name = freeGroupName(state.document.rig(), "group");
  const std::string what = namedMuscles(state.document.rig(), indices);
  if (!edit(state, "Group " + what, moveToNewGroup(state.document.rig(), indices, name))) return;
  const GroupId added = at(state.document.rig().groups, findGroup(state.document.rig(), name)).id();
  state.open.blending.group = added;
  state.view.outliner.tab = LeftTab::kGroups;
  state.view.layout.leftShown = true;
  state.open.blending.rename = {added, name, true};
}

bool renameGroupTo(EditorState& state, GroupId group, const std::string& name) {
  const int index = findGroup(state.document.rig(), group);
  if (index < 0 || nameOfGroup(state.document.rig(), index) == name) return index >= 0;
  const std::string label = "Rename group " + nameOfGroup(state.document.rig(), index) + " to " + name;
  return edit(state, label, renameGroup(state.document.rig(), index, name));
}

bool removeGroupOf(EditorState& state, int group, int into) {
  const Rig& rig = state.document.rig();
  const std::string label = "Delete group " + nameOfGroup(rig, group);
  return edit(state, label, into < 0 ? removeGroup(rig, group) : dissolveGroup(rig, group, into));
}

bool moveToGroup(EditorState& state, const std::vector<int>& indices, const std::string& group) {
  return edit(state, "Move " + namedMuscles(state.document.rig(), indices) + " to " + group,
              setGroupOfSeveral(state.document.rig(), indices, group));
}

void selectMembers(Document& document, const std::string& group) {
  document.selection.clear();
  for (const int index : membersOf(document.rig(), group))
    document.selection.primitives.push_back(document.idAt(index));
  completeSheets(document);
}

std::vector<int> draggedMuscles(const Document& document, int grabbed) {
  const auto index = static_cast<std::size_t>(grabbed);
  if (index >= document.rig().primitives.size()) return {};
  if (document.selection.contains(document.idAt(grabbed))) return selectedIndices(document);
  return membersOfMuscle(document.rig(), grabbed);
}

void highlightGroup(EditorState& state, const std::string& group) {
  const std::vector<int> members = membersOf(state.document.rig(), group);
  state.frame.highlighted.insert(state.frame.highlighted.end(), members.begin(), members.end());
}

}  // namespace sinew::app
