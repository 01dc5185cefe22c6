// app/panels/palette_words.cpp: buttons of panels as commands; what other programs call the actions.

#include "app/panels/palette_words.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/editor/layer_commands.h"
#include "app/editor/line_commands.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

Possible onLines(const EditorState& state) {
  if (!state.hasCharacter()) return {false, "Open a character first"};
  if (state.open.gestureItem != 0 || ownsKeyboard(state.view.tools)) return {false, "Finish the current edit first"};
  return {!selectedLines(state.document).indices.empty(), "Select a muscle that rides a line first"};
}

bool anyLine(const EditorState& state, bool withVia) {
  const SelectedLines lines = selectedLines(state.document);
  const auto& all = state.document.rig().lines;
  return std::ranges::any_of(lines.indices, [&](int line) { return at(all, line).via.has_value() == withVia; });
}

Possible withoutVia(const EditorState& state) {
  const Possible lines = onLines(state);
  return lines ? Possible(anyLine(state, false), "The line has a via point already") : lines;
}

Possible withVia(const EditorState& state) {
  const Possible lines = onLines(state);
  return lines ? Possible(anyLine(state, true), "The line has no via point") : lines;
}

Possible onPart(const EditorState& state) {
  const bool idle = state.open.gestureItem == 0 && !ownsKeyboard(state.view.tools);
  return Possible(state.hasCharacter(), "Open a character first")
      .also(hasParts(state), "This character is a single part")
      .also(state.open.layers.chosen >= 0, "Choose a part in the panel Layers first")
      .also(idle, "Finish the current edit first");
}

Possible onSetPart(const EditorState& state) {
  const Possible part = onPart(state);
  return part ? Possible(isLayerSet(state, state.open.layers.chosen), "The part is as guessed") : part;
}

template <SkinLayer kLayer>
void setChosenPart(EditorState& state) {
  setPartLayer(state, state.open.layers.chosen, kLayer);
}

void guessChosenPart(EditorState& state) { setPartLayer(state, state.open.layers.chosen, std::nullopt); }

constexpr PanelCommand kCommands[] = {
    {"panel/learn", "Learn contraction from clips", "Inspector: Set > Learn", "flex full analyze", onLines,
     learnContraction},
    {"panel/rest-now", "Rest length = now", "Inspector: Set > Rest", "relaxed neutral", onLines, setRestToNow},
    {"panel/full-now", "Full contraction = now", "Inspector: Set > Full", "flexed", onLines, setFullContractionToNow},
    {"panel/via-add", "Add via point", "Inspector: Via point > Add", "bend waypoint", withoutVia, addViaPoints},
    {"panel/via-remove", "Remove via point", "Inspector: Via point > Remove", "straighten", withVia, removeViaPoints},
    {"panel/rigid", "Make rigid", "Inspector: Ends > Rigid", "off the line detach", onLines, takeOffLines},
    {"panel/layer-skin", "Make the part skin", "Inspector: Layers", "layer mesh body muscles", onPart,
     setChosenPart<SkinLayer::kSkin>},
    {"panel/layer-cloth", "Make the part cloth", "Inspector: Layers", "layer mesh clothes hair garment", onPart,
     setChosenPart<SkinLayer::kCloth>},
    {"panel/layer-rigid", "Make the part rigid", "Inspector: Layers", "layer mesh eyes teeth", onPart,
     setChosenPart<SkinLayer::kRigid>},
    {"panel/layer-guess", "Guess the part's layer", "Inspector: Layers > Guess", "mesh automatic reset", onSetPart,
     guessChosenPart},
};

constexpr std::array kSynonyms{
    std::pair<std::string_view, std::string_view>{"edit/duplicate", "clone copy"},
    std::pair<std::string_view, std::string_view>{"edit/delete", "remove erase"},
    std::pair<std::string_view, std::string_view>{"edit/mirror", "reflect other side left right"},
    std::pair<std::string_view, std::string_view>{"edit/symmetry", "mirror both sides"},
    std::pair<std::string_view, std::string_view>{"edit/select-none", "deselect clear"},
    std::pair<std::string_view, std::string_view>{"edit/key", "keyframe animate"},
    std::pair<std::string_view, std::string_view>{"tool/add-muscle", "draw sketch paint create"},
    std::pair<std::string_view, std::string_view>{"tool/muscle-line", "draw stretch create flex"},
    std::pair<std::string_view, std::string_view>{"view/primitives", "ellipsoids shells"},
    std::pair<std::string_view, std::string_view>{"view/wire", "wireframe mesh topology"},
    std::pair<std::string_view, std::string_view>{"view/skeleton", "bones joints rig"},
    std::pair<std::string_view, std::string_view>{"view/clay", "matcap gray solid"},
    std::pair<std::string_view, std::string_view>{"view/before", "bare original compare"},
    std::pair<std::string_view, std::string_view>{"view/numbers", "fps statistics"},
    std::pair<std::string_view, std::string_view>{"file/add-clips", "import animation motion file retarget"},
    std::pair<std::string_view, std::string_view>{"play/clip-files", "added animation files remove locate missing"},
    std::pair<std::string_view, std::string_view>{"play/read-clip-files", "reload refresh update animation changed"},
    std::pair<std::string_view, std::string_view>{"file/export-character", "save as glb usd game"},
    std::pair<std::string_view, std::string_view>{"file/export-farm", "slurm batch render"},
};

}  // namespace

std::span<const PanelCommand> panelCommands() { return kCommands; }

std::string_view synonymsOf(std::string_view actionId) {
  const auto found = std::ranges::find(kSynonyms, actionId, &std::pair<std::string_view, std::string_view>::first);
  return found == kSynonyms.end() ? std::string_view() : found->second;
}

}  // namespace sinew::app
