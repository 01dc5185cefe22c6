// app/panels/palette_controls.cpp: the table of controls, and how each is brought into sight.

#include "app/panels/palette_controls.h"

#include <algorithm>

#include "app/editor/actions.h"
#include "app/editor/layer_commands.h"
#include "app/editor/line_commands.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr const char* kPlacement = "inspector/section/placement";
constexpr const char* kEffect = "inspector/section/effect";
constexpr const char* kOfLine = "inspector/section/line";
constexpr const char* kTerritory = "inspector/section/territory";

Possible withCharacter(const EditorState& state) { return {state.hasCharacter(), "Open a character first"}; }
Possible withMuscle(const EditorState& state) {
  return withCharacter(state).also(state.document.activePrimitive() >= 0, "Select a muscle first");
}
Possible withLine(const EditorState& state) {
  return withMuscle(state).also(!selectedLines(state.document).indices.empty(),
                                "Select a muscle that rides a line first");
}
Possible rigid(const EditorState& state) {
  return withMuscle(state).also(selectedLines(state.document).indices.empty(), "The muscle rides a line");
}
Possible uniform(const EditorState& state) {
  return withCharacter(state).also(state.document.rig().smoothing.detail == DetailKind::kUniform,
                                   "Choose the detail Uniform first");
}
Possible adaptive(const EditorState& state) {
  return withCharacter(state).also(state.document.rig().smoothing.detail == DetailKind::kAdaptive,
                                   "Choose the detail Adaptive first");
}
Possible withMorphs(const EditorState& state) {
  const bool any = state.hasCharacter() && !state.character().morphTargets.empty();
  return withCharacter(state).also(any, "This character has no shapes");
}
Possible withParts(const EditorState& state) {
  return withCharacter(state).also(hasParts(state), "This character is a single part");
}
Possible withSetLayers(const EditorState& state) {
  return withParts(state).also(!state.document.rig().layers.empty(), "All layers are as guessed");
}
Possible withHelpers(const EditorState& state) {
  const std::vector<bool>& helpers = state.open.helperBones;
  return withCharacter(state).also(std::ranges::find(helpers, true) != helpers.end(),
                                   "This character has no helper bones");
}
Possible withLines(const EditorState& state) {
  return withCharacter(state).also(!state.document.rig().lines.empty(), "No muscle rides a line");
}
Possible exportable(const EditorState& state) { return action("file/export-character").enabled(state); }
Possible farmable(const EditorState& state) { return action("file/export-farm").enabled(state); }
Possible always(const EditorState& /*state*/) { return {}; }

constexpr PaletteControl kControls[] = {
    {"outliner/tab", "Tab Muscles", "outliner bones tree list hierarchy", Shelf::kMuscles, "", withCharacter},
    {"blending/tab", "Tab Groups", "blending cliques", Shelf::kGroups, "", withCharacter},
    {"library/tab", "Tab Library", "presets sets", Shelf::kLibrary, "", withCharacter},
    {"shapes/tab", "Tab Shapes", "morph targets blend shapes", Shelf::kShapes, "", withCharacter},
    {"inspector/header", "Panel Muscle", "inspector properties", Shelf::kMuscle, "", always},
    {"surface/header", "Panel Surface", "properties settings", Shelf::kSurface, "", always},
    {"smoothing/header", "Panel Smoothing", "properties settings", Shelf::kSmoothing, "", always},
    {"layers/header", "Panel Layers", "parts of the mesh skin cloth rigid clothes hair eyes", Shelf::kLayers, "",
     withParts},
    {"inspector/section/placement", "Section Placement", "centre rotation radii", Shelf::kMuscle, "", withMuscle},
    {"inspector/section/effect", "Section Effect", "reach amount", Shelf::kMuscle, "", withMuscle},
    {"inspector/section/line", "Section Muscle line", "lengths tendons volume", Shelf::kMuscle, "", withLine},
    {"inspector/section/territory", "Section Territory", "bones skin", Shelf::kMuscle, "", withMuscle},
    {"outliner/search", "Search muscles and bones", "filter find list tree", Shelf::kMuscles, "", withCharacter},
    {"outliner/order/bones", "Order of the muscles", "bones regions groups list tree sort", Shelf::kMuscles, "",
     withCharacter},
    {"outliner/only-with-muscles", "Only bones with muscles", "filter hide empty", Shelf::kMuscles, "", withCharacter},
    {"outliner/helper-bones", "Show helper bones", "ik targets sockets hidden", Shelf::kMuscles, "", withHelpers},
    {"blending/view/matrix", "Groups as matrix or graph", "blend links nodes table", Shelf::kGroups, "", withCharacter},
    {"blending/add", "New group", "blend create", Shelf::kGroups, "", withCharacter},
    {"library/search", "Search the library", "find presets sets", Shelf::kLibrary, "", withCharacter},
    {"shapes/search", "Search shapes", "morph targets blend shapes find", Shelf::kShapes, "", withMorphs},
    {"shapes/reset", "Reset shapes", "morph targets blend shapes zero", Shelf::kShapes, "", withMorphs},
    {"inspector/name", "Name of the muscle", "rename", Shelf::kMuscle, "", withMuscle},
    {"inspector/bone", "Bone of the muscle", "parent reparent joint", Shelf::kMuscle, "", withMuscle},
    {"inspector/group", "Group of the muscle", "blend", Shelf::kMuscle, "", withMuscle},
    {"inspector/center.x", "Centre", "center position place move x y z", Shelf::kMuscle, kPlacement, withMuscle},
    {"inspector/rotation.x", "Rotation", "angle turn orientation x y z", Shelf::kMuscle, kPlacement, withMuscle},
    {"inspector/radius.x", "Radii", "radius size scale thickness length x y z", Shelf::kMuscle, kPlacement, withMuscle},
    {"inspector/lengths/units", "Lengths in units or % of the height", "per cent percent", Shelf::kMuscle, kPlacement,
     withMuscle},
    {"inspector/shape", "Shape of the muscle", "ellipsoid capsule egg spindle form", Shelf::kMuscle, "", withMuscle},
    {"inspector/core", "Straight", "capsule cylinder core shape", Shelf::kMuscleShape, "", withMuscle},
    {"inspector/belly", "Belly", "egg cone shape thicker end", Shelf::kMuscleShape, "", withMuscle},
    {"inspector/bend.x", "Bend", "curve spindle shape sideways", Shelf::kMuscleShape, "", withMuscle},
    {"inspector/other-end", "Other end", "attach bone line insertion stretch", Shelf::kMuscleShape, "", rigid},
    {"inspector/reach", "Reach", "influence falloff softness", Shelf::kMuscle, kEffect, withMuscle},
    {"inspector/amount", "Amount", "strength weight opacity", Shelf::kMuscle, kEffect, withMuscle},
    {"inspector/adds", "Effect: adds or carves", "sign subtract negative positive", Shelf::kMuscle, kEffect,
     withMuscle},
    {"inspector/line/length", "Length of the muscle line", "stretch now range", Shelf::kMuscle, "", withLine},
    {"inspector/line/flex-height", "Flex height", "bulge higher contraction", Shelf::kMuscle, "", withLine},
    {"inspector/line/flex-width", "Flex width", "bulge wider contraction", Shelf::kMuscle, "", withLine},
    {"inspector/line/rest", "Rest length", "relaxed neutral", Shelf::kMuscle, kOfLine, withLine},
    {"inspector/line/full", "Full contraction", "flexed shortest", Shelf::kMuscle, kOfLine, withLine},
    {"inspector/line/volume", "Volume", "preserve girth squash stretch", Shelf::kMuscle, kOfLine, withLine},
    {"inspector/line/tendon-origin", "Tendon at the origin", "sinew start", Shelf::kMuscle, kOfLine, withLine},
    {"inspector/line/tendon-insertion", "Tendon at the insertion", "sinew end", Shelf::kMuscle, kOfLine, withLine},
    {"inspector/line/pivot", "Pivot", "girth side bone", Shelf::kMuscle, kOfLine, withLine},
    {"inspector/line/twist", "Twist", "roll turn belly", Shelf::kMuscle, kOfLine, withLine},
    {"inspector/line/base", "Activation by hand", "active tone", Shelf::kMuscle, kOfLine, withLine},
    {"inspector/line/gain", "Activation from shortening", "active automatic", Shelf::kMuscle, kOfLine, withLine},
    {"inspector/territory", "Territory", "bones skin region mask limit", Shelf::kMuscle, kTerritory, withMuscle},
    {"inspector/territory-add", "Add a bone to the territory", "skin region mask", Shelf::kMuscle, kTerritory,
     withMuscle},
    {"surface/mode", "Surface mode", "swell replace", Shelf::kSurface, "", withCharacter},
    {"surface/iso", "Tightness", "iso value threshold wrap", Shelf::kSurface, "", withCharacter},
    {"surface/skin-blend", "Skin blend", "soft rise transition", Shelf::kSurface, "", withCharacter},
    {"smoothing/depth", "Depth", "subdivision level resolution fine", Shelf::kSmoothing, "", uniform},
    {"smoothing/tolerance", "Tolerance", "adaptive error subdivision fine", Shelf::kSmoothing, "", adaptive},
    {"smoothing/auto", "Automatic detail", "size on screen lod", Shelf::kSmoothing, "", withCharacter},
    {"smoothing/detail", "Detail: adaptive or uniform", "subdivision", Shelf::kSmoothing, "", withCharacter},
    {"smoothing/patch", "Rounding", "patch curve smooth pn phong spherigon flat", Shelf::kSmoothing, "", withCharacter},
    {"smoothing/crease", "Crease angle", "hard edge sharp normals", Shelf::kSmoothing, "", withCharacter},
    {"layers/guess-all", "Guess all layers", "parts of the mesh skin cloth rigid reset automatic", Shelf::kLayers, "",
     withSetLayers},
    {"timeline/clip", "Clip", "animation choose", Shelf::kTimeline, "", withCharacter},
    {"timeline/speed", "Speed", "playback slow fast", Shelf::kTimeline, "", withCharacter},
    {"view/flex-slider", "How hard muscles flex in the picture", "contract preview tension", Shelf::kPicture, "",
     withLines},
    {"preferences/keymap/maya", "Keymap", "maya blender keyboard shortcuts hotkeys", Shelf::kPreferences, "", always},
    {"preferences/scale", "Size of the interface", "scale zoom font text dpi", Shelf::kPreferences, "", always},
    {"preferences/moving/automatic", "Resolution while moving", "pixels speed fast quality", Shelf::kPreferences, "",
     always},
    {"preferences/surface/automatic", "Surface computed by", "graphics card gpu processor cpu speed fast",
     Shelf::kPreferences, "", always},
    {"preferences/autosave", "Autosave", "recovery backup crash seconds", Shelf::kPreferences, "", always},
    {"preferences/reset-layout", "Button Reset layout", "panels sizes default", Shelf::kPreferences, "", always},
    {"preferences/forget", "Clear recent files", "history forget", Shelf::kPreferences, "", always},
    {"preferences/keys/search", "Change a key", "shortcut hotkey keyboard binding customize", Shelf::kKeys, "", always},
    {"preferences/keys/reset-all", "Reset all keys", "shortcut hotkey default", Shelf::kKeys, "", always},
    {"export/kind/muscle joints", "Export: kind of character", "game engine skinned baked morph helper format",
     Shelf::kExport, "", exportable},
    {"export/place", "Export: file", "path folder name", Shelf::kExport, "", exportable},
    {"export/ok", "Export: write the file", "start run", Shelf::kExport, "", exportable},
    {"farm/job", "Farm job: folder", "path place", Shelf::kFarm, "", farmable},
};

void unfold(EditorState& state, const char* id) { std::erase(state.view.layout.folded, id); }

void openLeft(EditorState& state, LeftTab tab) {
  state.view.layout.leftShown = true;
  state.view.outliner.tab = tab;
}

void openRight(EditorState& state, const char* panel) {
  state.view.layout.rightShown = true;
  unfold(state, panel);
}

void open(EditorState& state, Shelf shelf) {
  switch (shelf) {
    case Shelf::kMuscles:
      return openLeft(state, LeftTab::kMuscles);
    case Shelf::kGroups:
      return openLeft(state, LeftTab::kGroups);
    case Shelf::kLibrary:
      return openLeft(state, LeftTab::kLibrary);
    case Shelf::kShapes:
      return openLeft(state, LeftTab::kShapes);
    case Shelf::kHistory:
      state.view.layout.leftShown = true;
      return;
    case Shelf::kMuscle:
    case Shelf::kMuscleShape:
      if (shelf == Shelf::kMuscleShape) state.view.inspector.shapeOpen = true;
      return openRight(state, "inspector");
    case Shelf::kSurface:
      return openRight(state, "surface");
    case Shelf::kSmoothing:
      return openRight(state, "smoothing");
    case Shelf::kLayers:
      return openRight(state, "layers");
    case Shelf::kTimeline:
      state.view.layout.bottomShown = true;
      return;
    case Shelf::kPicture:
      return;
    case Shelf::kPreferences:
    case Shelf::kKeys:
      state.dialogs.preferences = true;
      state.dialogs.preferencesPage = shelf == Shelf::kKeys ? PreferencesPage::kKeys : PreferencesPage::kGeneral;
      return;
    case Shelf::kExport:
      return run(action("file/export-character"), state);
    case Shelf::kFarm:
      return run(action("file/export-farm"), state);
  }
}

}  // namespace

std::span<const PaletteControl> paletteControls() { return kControls; }

const char* titleOf(Shelf shelf) {
  switch (shelf) {
    case Shelf::kMuscles:
      return "Tab Muscles";
    case Shelf::kGroups:
      return "Tab Groups";
    case Shelf::kLibrary:
      return "Tab Library";
    case Shelf::kShapes:
      return "Tab Shapes";
    case Shelf::kHistory:
      return "History";
    case Shelf::kMuscle:
    case Shelf::kMuscleShape:
      return "Inspector: Muscle";
    case Shelf::kSurface:
      return "Inspector: Surface";
    case Shelf::kSmoothing:
      return "Inspector: Smoothing";
    case Shelf::kLayers:
      return "Inspector: Layers";
    case Shelf::kTimeline:
      return "Timeline";
    case Shelf::kPicture:
      return "Picture";
    case Shelf::kPreferences:
      return "Preferences";
    case Shelf::kKeys:
      return "Preferences: Keys";
    case Shelf::kExport:
      return "Export dialog";
    case Shelf::kFarm:
      return "Farm dialog";
  }
  return "";
}

std::string whyNotThere(const PaletteControl& control, const EditorState& state) {
  return control.enabled(state).reason();
}

void revealControl(EditorState& state, const PaletteControl& control) {
  open(state, control.shelf);
  unfold(state, control.section);
  state.dialogs.reveal = {control.id};
}

void revealPart(EditorState& state, int part) {
  open(state, Shelf::kLayers);
  state.open.layers.chosen = part;
  state.dialogs.reveal = {"layers/part/" + at(state.character().parts, part).name};
}

void revealInLibrary(EditorState& state, const SetEntry& entry) {
  openLeft(state, LeftTab::kLibrary);
  state.open.library.search.clear();
  state.open.library.folded.erase(entry.set);
  state.dialogs.reveal = {"library/" + entry.set + (entry.muscle.empty() ? "" : "/" + entry.muscle)};
}

}  // namespace sinew::app
