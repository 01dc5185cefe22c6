// app/panels/action_table.cpp: every action: name, key, when, what.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/panels/actions.h"
#include "app/panels/commands.h"

namespace sinew::app {
namespace {

using State = EditorState;

// When.
bool always(const State&) { return true; }
bool open(const State& s) { return s.hasCharacter(); }
bool free(const State& s) { return s.hasCharacter() && !ownsKeyboard(s.tools) && s.gestureItem == 0; }
bool undoable(const State& s) { return free(s) && s.document.commands.canUndo(); }
bool redoable(const State& s) { return free(s) && s.document.commands.canRedo(); }
bool selected(const State& s) { return free(s) && s.document.activePrimitive() >= 0; }
bool boneKnown(const State& s) { return free(s) && s.document.selection.bone >= 0; }
bool playable(const State& s) { return s.hasCharacter() && clipDuration(s.transport, s.character()) > 0.0; }

// What. Small enough to stand in the table where they fit on a line.
void saveAs(State& s) { showSaveDialog(s, {}); }
void saveNow(State& s) { save(s, {}); }
void renameActive(State& s) { startRename(s, s.document.selection.active()); }
void addOnBone(State& s) { addMuscle(s, s.document.selection.bone); }
void frame(State& s) { frameSelection(s, true); }
void togglePlay(State& s) { togglePlaying(s.transport, s.character()); }
void next(State& s) { stepFrames(s.transport, 1, s.character()); }
void previous(State& s) { stepFrames(s.transport, -1, s.character()); }
void toStart(State& s) { s.transport.time = 0.0; }
void resetLayout(State& s) { s.layout = {}; }

template <Shading kShading>
bool isShaded(const State& s) {
  return s.display.shading == kShading;
}
template <Shading kShading>
void shade(State& s) {
  s.display.shading = kShading;
}

template <bool DisplaySettings::*kFlag>
bool isShown(const State& s) {
  return s.display.*kFlag;
}
template <bool DisplaySettings::*kFlag>
void toggleShown(State& s) {
  s.display.*kFlag = !(s.display.*kFlag);
}

template <ToolKind kTool>
bool isTool(const State& s) {
  return s.tools.tool == kTool;
}
template <ToolKind kTool>
void chooseTool(State& s) {
  setTool(s.tools, kTool);
}

template <StandardView kView>
void look(State& s) {
  showStandardView(s.tools.camera, kView);
}

bool isLooping(const State& s) { return s.transport.loop; }
void toggleLoop(State& s) { s.transport.loop = !s.transport.loop; }
bool isOrthographic(const State& s) { return s.tools.camera.orthographic; }
void toggleOrthographic(State& s) { s.tools.camera.orthographic = !s.tools.camera.orthographic; }
bool hasOverlay(const State& s) { return s.layout.overlay; }
void toggleOverlay(State& s) { s.layout.overlay = !s.layout.overlay; }
bool hasSheet(const State& s) { return s.keySheet; }
void toggleSheet(State& s) { s.keySheet = !s.keySheet; }
void reopenFile(State& s) { request(s, {IntentKind::kReopen, {}}); }
void quitEditor(State& s) { request(s, {IntentKind::kQuit, {}}); }

constexpr Shortcut kNone{};
constexpr Shortcut key(int code) { return {code, false, false}; }
constexpr Shortcut ctrl(int code) { return {code, true, false}; }
constexpr Shortcut ctrlShift(int code) { return {code, true, true}; }

using D = DisplaySettings;

constexpr Menu kMenus[] = {{"file", "File"}, {"edit", "Edit"}, {"view", "View"},
                           {"tool", "Tool"}, {"play", "Play"}, {"help", "Help"}};

const Action kActions[] = {
    {"file/open", "Open...", "Open a character (.glb, .gltf) or a rig (.rig.json)", ctrl(GLFW_KEY_O), kNone, always,
     nullptr, showOpenDialog},
    {"file/save", "Save", "Write the rig to its file", ctrl(GLFW_KEY_S), kNone, free, nullptr, saveNow, true},
    {"file/save-as", "Save as...", "Write the rig to another file", ctrlShift(GLFW_KEY_S), kNone, free, nullptr,
     saveAs},
    {"file/reopen", "Reopen", "Go back to what is on the disk", kNone, kNone, free, nullptr, reopenFile},
    {"file/quit", "Quit", "Close the editor", ctrl(GLFW_KEY_Q), kNone, always, nullptr, quitEditor, true},

    {"edit/undo", "Undo", "Take the last change back", ctrl(GLFW_KEY_Z), kNone, undoable, nullptr, undo},
    {"edit/redo", "Redo", "Do it again after all", ctrlShift(GLFW_KEY_Z), ctrl(GLFW_KEY_Y), redoable, nullptr, redo},
    {"edit/add-on-bone", "Add muscle on bone", "Put a muscle in the middle of the selected bone", ctrl(GLFW_KEY_M),
     kNone, boneKnown, nullptr, addOnBone, true},
    {"edit/duplicate", "Duplicate", "Copy the selected muscles", ctrl(GLFW_KEY_D), kNone, selected, nullptr,
     duplicateSelection},
    {"edit/rename", "Rename", "Give the selected muscle another name", key(GLFW_KEY_F2), kNone, selected, nullptr,
     renameActive},
    {"edit/delete", "Delete", "Remove the selected muscles", key(GLFW_KEY_DELETE), kNone, selected, nullptr,
     deleteSelection},
    {"edit/select-none", "Select nothing", "Let go of muscles and bone", key(GLFW_KEY_ESCAPE), kNone, free, nullptr,
     selectNothing, true},

    {"view/textured", "Textured", "The character's own materials", key(GLFW_KEY_1), kNone, open,
     isShaded<Shading::kTextured>, shade<Shading::kTextured>},
    {"view/clay", "Clay", "One even material that shows the form", key(GLFW_KEY_2), kNone, open,
     isShaded<Shading::kClay>, shade<Shading::kClay>},
    {"view/classes", "Classes", "Triangles by class: implicit, straddling, normal", key(GLFW_KEY_3), kNone, open,
     isShaded<Shading::kClasses>, shade<Shading::kClasses>},
    {"view/heat", "Displacement", "How far the skin was lifted or pushed in", key(GLFW_KEY_4), kNone, open,
     isShaded<Shading::kHeat>, shade<Shading::kHeat>},
    {"view/wire", "Wire", "Edges of the refined mesh", key(GLFW_KEY_5), kNone, open, isShown<&D::wire>,
     toggleShown<&D::wire>, true},
    {"view/control-mesh", "Control mesh", "Edges of the mesh in the file", key(GLFW_KEY_6), kNone, open,
     isShown<&D::controlMesh>, toggleShown<&D::controlMesh>},
    {"view/skeleton", "Skeleton", "Bones, seen through the skin", key(GLFW_KEY_7), kNone, open, isShown<&D::skeleton>,
     toggleShown<&D::skeleton>},
    {"view/primitives", "Muscles", "All ellipsoids, not the selected alone", key(GLFW_KEY_8), kNone, open,
     isShown<&D::primitives>, toggleShown<&D::primitives>},
    {"view/influence", "Influence", "How far the shown muscles reach", key(GLFW_KEY_9), kNone, open,
     isShown<&D::influence>, toggleShown<&D::influence>},
    {"view/ground", "Ground", "Grid and shadow", key(GLFW_KEY_0), kNone, open, isShown<&D::ground>,
     toggleShown<&D::ground>},
    {"view/cull", "Skip hidden sides", "Leave out, before it is computed, what turns away from the eye", kNone, kNone,
     open, isShown<&D::cullBackFaces>, toggleShown<&D::cullBackFaces>},
    {"view/numbers", "Numbers", "Frame times and counts over the picture", kNone, kNone, open, hasOverlay,
     toggleOverlay},
    {"view/frame", "Frame selection", "Bring the selected muscles, or all, into the picture", key(GLFW_KEY_F),
     key(GLFW_KEY_HOME), open, nullptr, frame, true},
    {"view/front", "Front", "Look at the front", key(GLFW_KEY_KP_1), kNone, open, nullptr, look<StandardView::kFront>},
    {"view/back", "Back", "Look at the back", ctrl(GLFW_KEY_KP_1), kNone, open, nullptr, look<StandardView::kBack>},
    {"view/left", "Left", "Look at the character's left", key(GLFW_KEY_KP_3), kNone, open, nullptr,
     look<StandardView::kLeft>},
    {"view/right", "Right", "Look at the character's right", ctrl(GLFW_KEY_KP_3), kNone, open, nullptr,
     look<StandardView::kRight>},
    {"view/top", "Top", "Look from above", key(GLFW_KEY_KP_7), kNone, open, nullptr, look<StandardView::kTop>},
    {"view/bottom", "Bottom", "Look from below", ctrl(GLFW_KEY_KP_7), kNone, open, nullptr,
     look<StandardView::kBottom>},
    {"view/orthographic", "Orthographic", "Without perspective", key(GLFW_KEY_KP_5), kNone, open, isOrthographic,
     toggleOrthographic},
    {"view/reset-layout", "Reset layout", "Bring the panels back to their sizes", kNone, kNone, always, nullptr,
     resetLayout, true},

    {"tool/select", "Select", "Click a muscle, or the skin over it", key(GLFW_KEY_Q), kNone, free,
     isTool<ToolKind::kSelect>, chooseTool<ToolKind::kSelect>},
    {"tool/move", "Move", "Drag the selected muscle", key(GLFW_KEY_W), kNone, free, isTool<ToolKind::kMove>,
     chooseTool<ToolKind::kMove>},
    {"tool/rotate", "Rotate", "Turn the selected muscle", key(GLFW_KEY_E), kNone, free, isTool<ToolKind::kRotate>,
     chooseTool<ToolKind::kRotate>},
    {"tool/scale", "Scale", "Change the selected muscle's radii", key(GLFW_KEY_R), kNone, free,
     isTool<ToolKind::kScale>, chooseTool<ToolKind::kScale>},
    {"tool/add-muscle", "Add muscle", "Press on the skin and drag: a muscle grows there", key(GLFW_KEY_M), kNone, free,
     isTool<ToolKind::kAddMuscle>, chooseTool<ToolKind::kAddMuscle>},
    {"tool/axes", "Next axes", "Handles along the world, the bone or the muscle", key(GLFW_KEY_X), kNone, free, nullptr,
     cycleAxes, true},

    {"play/toggle", "Play or pause", "Let the clip run", key(GLFW_KEY_SPACE), kNone, playable, nullptr, togglePlay},
    {"play/previous", "Previous frame", "One frame back", key(GLFW_KEY_COMMA), key(GLFW_KEY_LEFT), playable, nullptr,
     previous},
    {"play/next", "Next frame", "One frame on", key(GLFW_KEY_PERIOD), key(GLFW_KEY_RIGHT), playable, nullptr, next},
    {"play/start", "To the start", "Back to the clip's first moment", ctrl(GLFW_KEY_LEFT), kNone, playable, nullptr,
     toStart},
    {"play/loop", "Loop", "Start over at the end", key(GLFW_KEY_L), kNone, playable, isLooping, toggleLoop, true},

    {"help/keys", "Keys and mouse", "This sheet", key(GLFW_KEY_F1), kNone, always, hasSheet, toggleSheet},
};

}  // namespace

std::span<const Menu> menus() { return kMenus; }

std::span<const Action> actions() { return kActions; }

}  // namespace sinew::app
