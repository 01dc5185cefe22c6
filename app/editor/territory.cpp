// app/editor/territory.cpp: which bones' skin a muscle may move.

#include "app/editor/territory.h"

#include "app/editor/edit.h"

#include "app/viewport/tools/territory_tool.h"
#include "core/geometry/at.h"
#include "core/rig/attachment.h"
#include "core/rig/rig_edit.h"

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

}  // namespace sinew::app
