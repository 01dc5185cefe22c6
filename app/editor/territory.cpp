// app/editor/territory.cpp: which bones' skin a muscle may move.

#include "app/editor/territory.h"

#include <algorithm>
#include <utility>

#include "app/editor/commands.h"
#include "core/rig/attachment.h"
#include "core/rig/rig_edit_several.h"

namespace sinew::app {
namespace {

/// Rig index of the mode's muscle, or -1.
int subject(const EditorState& state) {
  if (!state.hasCharacter() || state.panels.territory.primitive.empty()) return -1;
  return findPrimitive(state.document.rig(), state.panels.territory.primitive);
}

int boneOf(const EditorState& state, int index) {
  const Primitive& primitive = state.document.rig().primitives[static_cast<std::size_t>(index)];
  return state.character().skeleton.findBone(primitive.bone).value_or(-1);
}

/// The names that stand for the territory in a file: those it has, or those of the default.
std::vector<std::string> namesOf(const Primitive& primitive, const Skeleton& skeleton) {
  if (primitive.territory) return *primitive.territory;
  std::vector<std::string> names;
  const std::optional<int> own = skeleton.findBone(primitive.bone);
  if (!own) return names;
  for (const int bone : territoryBones(primitive, *own, skeleton)) names.push_back(skeleton.fileName(bone));
  return names;
}

}  // namespace

bool editsTerritory(const EditorState& state) { return subject(state) >= 0; }

void toggleTerritoryMode(EditorState& state) {
  if (editsTerritory(state)) {
    endTerritoryMode(state);
  } else if (state.document.activePrimitive() >= 0) {
    state.panels.territory.primitive = state.document.selection.active();
  }
}

void endTerritoryMode(EditorState& state) { state.panels.territory = {}; }

void runTerritoryMode(EditorState& state) {
  TerritoryState& mode = state.panels.territory;
  if (!mode.primitive.empty()) {
    const int active = state.document.activePrimitive();
    mode.primitive = active >= 0 ? state.document.selection.active() : "";
    if (active >= 0 && boneOf(state, active) < 0) mode.primitive.clear();
  }
  const int picked = std::exchange(state.route.pickedBone, -1);
  if (editsTerritory(state) && picked >= 0) toggleTerritoryBone(state, picked);
  state.tools.pickBones = editsTerritory(state);
}

Result<Rig> withTerritoryBone(const Rig& rig, int index, int bone, const Skeleton& skeleton) {
  std::vector<std::string> names = namesOf(rig.primitives[static_cast<std::size_t>(index)], skeleton);
  const auto removed = std::erase_if(names, [&](const std::string& name) { return skeleton.findBone(name) == bone; });
  if (removed == 0) names.push_back(skeleton.fileName(bone));
  const bool any =
      std::ranges::any_of(names, [&](const std::string& name) { return skeleton.findBone(name).has_value(); });
  if (!any) return errorAt("territory", "a muscle must be allowed to move the skin of one bone at least");
  return editPrimitives(rig, std::vector<int>{index}, [&](Primitive& primitive) { primitive.territory = names; });
}

Result<Rig> withDefaultTerritory(const Rig& rig, const std::vector<int>& indices) {
  return editPrimitives(rig, indices, [](Primitive& primitive) { primitive.territory.reset(); });
}

void toggleTerritoryBone(EditorState& state, int bone) {
  const int index = editsTerritory(state) ? subject(state) : state.document.activePrimitive();
  if (index < 0) return;
  Result<Rig> changed = withTerritoryBone(state.document.rig(), index, bone, state.character().skeleton);
  state.fieldError = changed ? "" : changed.error().reason;
  if (!changed) return;
  const std::string& name = state.document.rig().primitives[static_cast<std::size_t>(index)].name;
  state.document.commands.apply("Territory of " + name, std::move(changed).value());
}

std::vector<int> shownTerritory(const EditorState& state) {
  const int index = subject(state);
  if (index < 0) return {};
  const int bone = boneOf(state, index);
  if (bone < 0) return {};
  return territoryBones(state.document.rig().primitives[static_cast<std::size_t>(index)], bone,
                        state.character().skeleton);
}

std::vector<float> shownTerritoryWeights(const EditorState& state) {
  const std::vector<int> bones = shownTerritory(state);
  std::vector<float> weights;
  if (bones.empty()) return weights;
  std::vector<bool> within(state.character().skeleton.bones.size(), false);
  for (const int bone : bones) within[static_cast<std::size_t>(bone)] = true;
  const std::size_t count = state.character().mesh.positions.size();
  weights.reserve(count);
  for (std::size_t v = 0; v < count; ++v) {
    weights.push_back(territoryWeight(state.character(), static_cast<int>(v), within));
  }
  return weights;
}

}  // namespace sinew::app
