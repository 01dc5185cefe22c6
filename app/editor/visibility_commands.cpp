// app/editor/visibility_commands.cpp: visibility of muscles and helper bones, and layers of the mesh.
#include "app/editor/visibility_commands.h"

#include <algorithm>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/ui/code_points.h"
#include "core/geometry/at.h"
#include "core/rig/mesh_layers.h"

namespace sinew::app {

bool hasParts(const EditorState& state) { return state.hasCharacter() && state.character().parts.size() > 1; }

std::vector<SkinLayer> partLayers(const EditorState& state) {
  return layersOf(state.document.rig(), state.character(), state.live->guessedLayers());
}

bool isLayerSet(const EditorState& state, int part) {
  return findLayer(state.document.rig(), at(state.character().parts, part).name) >= 0;
}

void setPartLayer(EditorState& state, int part, std::optional<SkinLayer> layer) {
  const std::vector<std::string> names = shownPartNames(state.character());
  const std::string& shown = at(names, part);
  const std::string label = layer ? "Layer of " + shown + ": " + nameOf(*layer) : "Layer of " + shown + " as guessed";
  edit(state, label, setLayer(state.document.rig(), at(state.character().parts, part).name, layer));
}

void guessAllLayers(EditorState& state) { edit(state, "All layers as guessed", withoutLayers(state.document.rig())); }

void forgetPart(EditorState& state, const std::string& name) {
  const int number = findLayer(state.document.rig(), name) + 1;
  edit(state, "Forget the layer of " + readableName(name, "part", number),
       setLayer(state.document.rig(), name, std::nullopt));
}

std::vector<LitPart> litParts(const EditorState& state) {
  if (!hasParts(state)) return {};
  const int hovered = state.frame.hoveredPart;
  const int chosen = state.open.layers.chosen;
  if (hovered < 0 && chosen < 0) return {};
  const std::vector<SkinLayer> layers = partLayers(state);
  std::vector<LitPart> lit;
  if (chosen >= 0 && chosen != hovered) lit.push_back({chosen, at(layers, chosen), false});
  if (hovered >= 0) lit.push_back({hovered, at(layers, hovered), true});
  return lit;
}

std::vector<bool> hiddenBones(const EditorState& state) {
  const std::vector<bool>& helpers = state.open.helperBones;
  if (!state.hasCharacter() || state.view.outliner.helperBones) return {};
  if (std::ranges::find(helpers, true) == helpers.end()) return {};
  std::vector<bool> hidden = helpers;
  const auto show = [&](int bone) {
    if (bone >= 0) at(hidden, bone) = false;
  };
  for (const int bone : boneOfEach(state.document.rig(), state.character().skeleton)) show(bone);
  for (const JointTurn& turn : state.open.transport.overrides.turns) show(turn.bone);
  for (const int bone : shownTerritory(state)) show(bone);
  show(state.document.selection.bone);
  return std::ranges::find(hidden, true) == hidden.end() ? std::vector<bool>{} : hidden;
}

bool isHidden(const std::vector<bool>& hidden, int bone) { return !hidden.empty() && at(hidden, bone); }

namespace {

/// A sheet by its first belly.
std::vector<PrimitiveId> selectedMuscles(const Document& document) {
  std::vector<PrimitiveId> muscles;
  for (const int lead : leadsOf(document.rig(), selectedIndices(document))) muscles.push_back(document.idAt(lead));
  return muscles;
}

/// Sets the mark on all selected, or takes it off if all have it.
void toggleMark(Document& document, Mark mark) {
  Visibility& visibility = document.visibility;
  const std::vector<PrimitiveId> muscles = selectedMuscles(document);
  const bool all =
      std::ranges::all_of(muscles, [&](PrimitiveId id) { return visibility.marks(mark).muscles.contains(id); });
  for (const PrimitiveId id : muscles) visibility.setMuscle(mark, id, !all);
}

}  // namespace

void followEdits(Document& document) { welcomeNew(document.visibility, document.rig(), document.character->skeleton); }

void toggleHideSelection(Document& document) { toggleMark(document, Mark::kHidden); }

void showAll(Document& document) {
  Visibility& visibility = document.visibility;
  visibility.hidden = {};
  visibility.solo = {};
  visibility.isolated.reset();
}

void toggleIsolation(Document& document) {
  Visibility& visibility = document.visibility;
  if (visibility.isolated) {
    visibility.isolated.reset();
    return;
  }
  const std::vector<PrimitiveId> muscles = selectedMuscles(document);
  if (!muscles.empty()) visibility.isolated.emplace(muscles.begin(), muscles.end());
}

void toggleLockSelection(Document& document) { toggleMark(document, Mark::kLocked); }

void unlockAll(Document& document) { document.visibility.locked = {}; }

bool anythingHidden(const Document& document) {
  const Visibility& visibility = document.visibility;
  return !visibility.hidden.empty() || !visibility.solo.empty() || visibility.isolated.has_value();
}

void latchBare(EditorState& state) { state.view.bare.latched = !state.view.bare.latched; }

void holdBare(EditorState& state, bool keyDown, bool buttonDown) {
  BareState& bare = state.view.bare;
  if (bare.byKey && !keyDown) bare.latched = false;
  bare.byKey = keyDown;
  state.document.visibility.bare = bare.latched || buttonDown;
}

std::string hiddenText(const Document& document) {
  const Visibility& visibility = document.visibility;
  if (visibility.bare) return "Before: without muscles";
  const Rig& rig = document.rig();
  const auto hidden = leadsOf(rig, hiddenPrimitives(visibility, rig, document.character->skeleton)).size();
  if (hidden == 0) return "";
  const std::string count = std::to_string(hidden) + " of " + std::to_string(allLeads(rig).size());
  return visibility.isolated ? "Isolated: " + count + " muscles hidden" : count + " muscles hidden";
}

}  // namespace sinew::app
