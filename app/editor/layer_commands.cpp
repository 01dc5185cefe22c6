// app/editor/layer_commands.cpp: edits of Rig::layers, and the parts that are lit up.

#include "app/editor/layer_commands.h"

#include "app/document/shown_names.h"
#include "app/editor/edit.h"
#include "app/ui/readable_names.h"
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

}  // namespace sinew::app
