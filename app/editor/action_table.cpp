// app/editor/action_table.cpp: the table of actions; the menus File, Edit, Muscles, Window and Help.
#include "app/editor/action_table.h"

#include <vector>

#include "app/document/listed_muscles.h"
#include "app/editor/animate.h"
#include "app/editor/blending_edit.h"
#include "app/editor/clip_commands.h"
#include "app/editor/export_commands.h"
#include "app/editor/fit_sculpt_commands.h"
#include "app/editor/muscle_set_commands.h"
#include "app/editor/open_file.h"
#include "app/editor/picture_commands.h"
#include "app/editor/session.h"
#include "app/editor/sheet_commands.h"
#include "app/editor/symmetry_commands.h"
#include "core/geometry/at.h"

namespace sinew::app::table {
namespace {

void saveAs(State& s) { showSaveDialog(s, {}); }
void saveNow(State& s) { save(s, {}); }
void reopenFile(State& s) { request(s, {IntentKind::kReopen, {}}); }
void showPreferences(State& s) { s.dialogs.preferences = true; }
void quitEditor(State& s) { request(s, {IntentKind::kQuit, {}}); }

Possible farmable(const State& s) { return idle(s).also(rigIsSaved(s), "Save the rig first"); }

const Action kFileActions[] = {
    {"file/open", "Open...", "Open a character (.glb, .gltf, .vrm) or a rig (.rig.json)", ctrl(GLFW_KEY_O), kNone,
     always, nullptr, showOpenDialog},
    {"file/save", "Save", "Write the rig to its file", ctrl(GLFW_KEY_S), kNone, idle, nullptr, saveNow, true},
    {"file/save-as", "Save as...", "Write the rig to another file", ctrlShift(GLFW_KEY_S), kNone, idle, nullptr,
     saveAs},
    {"file/reopen", "Reopen", "Read the file again as it is on disk", kNone, kNone, idle, nullptr, reopenFile},
    {"file/add-clips", "Add clips...", "Let the character play the clips of another file too (.glb, .gltf, .vrm)",
     kNone, kNone, idle, nullptr, showClipsDialog, true},
    {"file/export-character", "Character for games...",
     "Write the character with its muscles for game engines and other programs: one mesh, joints, clips",
     ctrlShift(GLFW_KEY_E), kNone, idle, nullptr, showExportDialog, true},
    {"file/export-farm", "As a farm job...",
     "Write a job that exports this rig, or all rigs of its folder, on the machines of a farm", kNone, kNone, farmable,
     nullptr, showFarmDialog},
    {"file/export-pictures", "Turntable or contact sheet...",
     "Write the character from all sides, or a clip, as a moving picture or as one sheet", kNone, kNone, open, nullptr,
     showPicturesDialog},
    {"file/save-picture", "Save picture...", "Write the picture, without the interface, to a PNG file", kNone, kNone,
     open, nullptr, showPictureDialog, true},
    {"file/save-picture-now", "Save picture now", "Write the picture to the folder of the last one, else to Pictures",
     key(GLFW_KEY_F12), kNone, open, nullptr, savePictureNow},
    {"file/preferences", "Preferences...", "Keys, size of the interface, autosave", ctrl(GLFW_KEY_COMMA), kNone, always,
     nullptr, showPreferences, true},
    {"file/quit", "Quit", "Close the editor", ctrl(GLFW_KEY_Q), kNone, always, nullptr, quitEditor, true},
};

template <bool LayoutState::*kFlag>
bool isPanelShown(const State& s) {
  return s.view.layout.*kFlag;
}
template <bool LayoutState::*kFlag>
void togglePanelShown(State& s) {
  s.view.layout.*kFlag = !(s.view.layout.*kFlag);
}

bool pictureAlone(const State& s) {
  return !s.view.layout.leftShown && !s.view.layout.rightShown && !s.view.layout.bottomShown;
}
void togglePictureAlone(State& s) {
  const bool all = pictureAlone(s);
  s.view.layout.leftShown = s.view.layout.rightShown = s.view.layout.bottomShown = all;
}
Possible hasMessages(const State& s) { return {!s.session.messages.empty(), "There are no messages"}; }
bool messagesShown(const State& s) { return s.session.messagesShown; }
void toggleMessages(State& s) { s.session.messagesShown = !s.session.messagesShown; }
void resetLayout(State& s) { s.view.layout = {}; }

using L = LayoutState;

const Action kWindowActions[] = {
    {"window/left", "Left panels", "Bones, muscles and history", key(GLFW_KEY_T), kNone, always,
     isPanelShown<&L::leftShown>, togglePanelShown<&L::leftShown>},
    {"window/right", "Right panels", "The selected muscle, surface and smoothing", key(GLFW_KEY_N), kNone, always,
     isPanelShown<&L::rightShown>, togglePanelShown<&L::rightShown>},
    {"window/bottom", "Timeline", "The clip and its time", ctrl(GLFW_KEY_T), kNone, always,
     isPanelShown<&L::bottomShown>, togglePanelShown<&L::bottomShown>},
    {"window/picture", "Only the picture", "Hide all panels, or show them again", ctrl(GLFW_KEY_SPACE), kNone, always,
     pictureAlone, togglePictureAlone},
    {"window/messages", "Messages", "Notes about imports and failures", kNone, kNone, hasMessages, messagesShown,
     toggleMessages, true},
    {"window/reset-layout", "Reset layout", "Return the panels to their default places and sizes", kNone, kNone, always,
     nullptr, resetLayout, true},
};

bool hasSheet(const State& s) { return s.dialogs.keySheet; }
void toggleSheet(State& s) { s.dialogs.keySheet = !s.dialogs.keySheet; }

bool hasFirstSteps(const State& s) { return s.view.firstSteps.shown; }

void openPalette(State& s) {
  showPalette(s.dialogs);
  s.dialogs.palette.sets = setEntries(s);
}

const Action kHelpActions[] = {
    {"help/first-steps", "First steps", "Five things to try on the walking man, each ticked off when it is done", kNone,
     kNone, always, hasFirstSteps, toggleFirstSteps},
    {"help/palette", "Find anything...", "Search actions, controls, muscles, bones, sets, samples and pages",
     ctrl(GLFW_KEY_P), kNone, always, nullptr, openPalette},
    {"help/keys", "Keys and mouse", "All keys and mouse drags", key(GLFW_KEY_F1), kNone, always, hasSheet, toggleSheet},
};

Possible undoable(const State& s) { return idle(s).also(s.document.commands.canUndo(), "Nothing to undo"); }
Possible redoable(const State& s) { return idle(s).also(s.document.commands.canRedo(), "Nothing to redo"); }
/// The selected bone, else the active muscle's, or -1.
int boneToAddOn(const State& s) {
  if (s.document.selection.bone >= 0) return s.document.selection.bone;
  const int active = s.document.activePrimitive();
  if (active < 0) return -1;
  const std::string& bone = at(s.document.rig().primitives, active).bone;
  return s.character().skeleton.findBone(bone).value_or(-1);
}
Possible boneKnown(const State& s) {
  const Possible free = idle(s);
  return free ? Possible(boneToAddOn(s) >= 0, "Select a bone or a muscle first") : free;
}
void renameActive(State& s) { startRename(s, s.document.idAt(s.document.activePrimitive())); }
void addOnBone(State& s) { addMuscle(s, boneToAddOn(s)); }
template <ShapePreset preset>
void addShaped(State& s) {
  addMuscle(s, boneToAddOn(s), preset);
}

constexpr const char* kNoSides = "This character has no left and right bones";
Possible mirrorable(const State& s) { return selected(s).also(canMirror(s.document), kNoSides); }
bool symmetric(const State& s) { return s.document.symmetry; }
Possible symmetryKnown(const State& s) { return idle(s).also(canMirror(s.document), kNoSides); }
Possible twinned(const State& s) { return selected(s).also(anyTwin(s.document), "No selected muscle has a twin"); }
Possible linkable(const State& s) { return mirrorable(s).also(twoSelected(s.document), "Select two muscles first"); }
Possible anyMuscle(const State& s) {
  return idle(s).also(!s.document.rig().primitives.empty(), "There are no muscles yet");
}
Possible sheetSelected(const State& s) {
  return selected(s).also(!selectedSheets(s.document).empty(), "Select a sheet first");
}
Possible boneOrMuscle(const State& s) {
  return anyMuscle(s).also(selected(s) || s.document.selection.bone >= 0, "Select a muscle or a bone first");
}
Possible keyable(const State& s) {
  const Possible free = idle(s);
  return free ? canKeyPointed(s) : free;
}
void deletePointed(State& s) {
  if (!removePointedPoint(s)) deleteSelection(s);
}
void paste(State& s) { pasteMuscles(s, false); }
void pasteMirrored(State& s) { pasteMuscles(s, true); }

const Action kEditActions[] = {
    {"edit/undo", "Undo", "Undo the last change", ctrl(GLFW_KEY_Z), kNone, undoable, nullptr, undo},
    {"edit/redo", "Redo", "Redo the change that was undone last", ctrlShift(GLFW_KEY_Z), ctrl(GLFW_KEY_Y), redoable,
     nullptr, redo},
    {"edit/add-on-bone", "Add muscle on bone",
     "Add a muscle in the middle of the selected bone, or of the selected muscle's bone", ctrl(GLFW_KEY_M), kNone,
     boneKnown, nullptr, addOnBone, true},
    {"edit/shape-capsule", "Capsule", "Add a muscle with straight sides and round ends on the bone", kNone, kNone,
     boneKnown, nullptr, addShaped<ShapePreset::kCapsule>},
    {"edit/shape-cylinder", "Cylinder", "Add a muscle with straight sides and nearly flat ends on the bone", kNone,
     kNone, boneKnown, nullptr, addShaped<ShapePreset::kCylinder>},
    {"edit/shape-egg", "Egg", "Add a muscle that is thicker towards one end on the bone", kNone, kNone, boneKnown,
     nullptr, addShaped<ShapePreset::kEgg>},
    {"edit/shape-cone", "Cone", "Add a muscle that tapers from one round end to the other on the bone", kNone, kNone,
     boneKnown, nullptr, addShaped<ShapePreset::kCone>},
    {"edit/shape-spindle", "Spindle (bent)", "Add a muscle whose middle is moved sideways on the bone", kNone, kNone,
     boneKnown, nullptr, addShaped<ShapePreset::kSpindle>},
    {"edit/duplicate", "Duplicate", "Copy the selected muscles", ctrl(GLFW_KEY_D), kNone, selected, nullptr,
     duplicateSelection},
    {"edit/rename", "Rename", "Rename the selected muscle", key(GLFW_KEY_F2), kNone, selected, nullptr, renameActive},
    {"edit/delete", "Delete", "Remove the selected muscles, or the point of a curve under the pointer",
     key(GLFW_KEY_DELETE), kNone, selected, nullptr, deletePointed},
    {"edit/group", "Group", "Put the selected muscles into a new group", ctrl(GLFW_KEY_G), kNone, selected, nullptr,
     groupSelection},
    {"edit/break-sheet", "Break into strips",
     "Make the bellies of the selected sheets muscles of their own, on a line for each strip if the sheet has lines",
     kNone, kNone, sheetSelected, nullptr, breakSelection},
    {"edit/key", "Key number",
     "Key the number under the pointer at this moment of the clip; while driven keys are set, set one at this pose",
     key(GLFW_KEY_K), kNone, keyable, nullptr, keyPointed},
    {"edit/cut", "Cut", "Copy the selected muscles and remove them", ctrl(GLFW_KEY_X), kNone, selected, nullptr,
     cutSelection, true},
    {"edit/copy", "Copy", "Put the selected muscles on the clipboard, as the text of a rig", ctrl(GLFW_KEY_C), kNone,
     selected, nullptr, onDocument<copySelection>},
    {"edit/paste", "Paste", "Add the muscles on the clipboard, from this character or another", ctrl(GLFW_KEY_V), kNone,
     idle, nullptr, paste},
    {"edit/paste-mirrored", "Paste mirrored", "Add the muscles on the clipboard on the other side",
     ctrlShift(GLFW_KEY_V), kNone, symmetryKnown, nullptr, pasteMirrored},
    {"edit/symmetry", "Symmetry", "Add, copy and delete on both sides at once", shift(GLFW_KEY_S), kNone, symmetryKnown,
     symmetric, onDocument<toggleSymmetry>, true},
    {"edit/mirror", "Mirror to other side", "Give each selected muscle a linked twin that follows it",
     ctrlShift(GLFW_KEY_M), kNone, mirrorable, nullptr, mirrorSelection},
    {"edit/flip", "Flip", "Move the selected muscles to the other side", ctrlShift(GLFW_KEY_F), kNone, mirrorable,
     nullptr, flipSelection},
    {"edit/unlink-twin", "Unlink twin", "The selected muscle and its twin no longer follow each other",
     ctrlShift(GLFW_KEY_U), kNone, twinned, nullptr, unlinkSelection},
    {"edit/link-twins", "Link as twins", "Make the first of two selected muscles the mirror image of the active one",
     ctrlShift(GLFW_KEY_L), kNone, linkable, nullptr, linkSelection},
    {"edit/select-twin", "Select twin", "Select the twin on the other side", ctrlShift(GLFW_KEY_T), kNone, twinned,
     nullptr, onDocument<selectTwins>},
    {"edit/select-all", "Select all", "All muscles that are shown and not locked", ctrl(GLFW_KEY_A), kNone, anyMuscle,
     nullptr, onDocument<selectAll>, true},
    {"edit/select-invert", "Invert selection", "Select every muscle that is not selected", ctrl(GLFW_KEY_I), kNone,
     anyMuscle, nullptr, onDocument<invertSelection>},
    {"edit/select-on-bone", "Select all on bone", "All muscles on the bones of the selected ones", ctrl(GLFW_KEY_B),
     kNone, boneOrMuscle, nullptr, onDocument<selectOnBone>},
    {"edit/select-none", "Select nothing", "Clear the selection of muscles and bone; once more leaves Add muscle",
     key(GLFW_KEY_ESCAPE), kNone, idle, nullptr, selectNothing},
};

bool showsLibrary(const State& s) { return s.view.layout.leftShown && s.view.outliner.tab == LeftTab::kLibrary; }
void showLibrary(State& s) {
  s.view.outliner.tab = showsLibrary(s) ? LeftTab::kMuscles : LeftTab::kLibrary;
  s.view.layout.leftShown = true;
}
bool showsParts(const State& s) { return s.open.bodyParts.shown; }

const Action kMuscleActions[] = {
    {"muscles/add-set", "Add muscle set", "Add the muscles of an athlete or an animal, placed by the parts of the body",
     kNone, kNone, idle, nullptr, addMuscleSet},
    {"muscles/body-parts", "Parts of the body",
     "Correct which bone is the thigh, the forearm and so on: muscle sets are placed by these parts", kNone, kNone,
     open, showsParts, toggleBodyParts, true},
    {"muscles/library", "Library", "Muscles of all sets with pictures, to add one at a time", kNone, kNone, open,
     showsLibrary, showLibrary},
    {"muscles/save-set", "Save as set...", "Save the selected muscles as a set of your own that fits any character",
     kNone, kNone, selected, nullptr, nameNewSet},
    {"muscles/fit-sculpt", "Fit to a sculpt...",
     "Change the muscles until the skin looks like a sculpt of the same body (.glb, .obj, .ply)", kNone, kNone,
     anyMuscle, nullptr, showSculptDialog, true},
    {"muscles/retarget", "Put on another character...",
     "Open another character with these muscles, each at its place on the other body", kNone, kNone, anyMuscle, nullptr,
     showRetargetDialog, true},
};

}  // namespace

std::span<const Action> fileActions() { return kFileActions; }
std::span<const Action> windowActions() { return kWindowActions; }
std::span<const Action> helpActions() { return kHelpActions; }
std::span<const Action> editActions() { return kEditActions; }
std::span<const Action> muscleActions() { return kMuscleActions; }

}  // namespace sinew::app::table

namespace sinew::app {
namespace {

constexpr Menu kMenus[] = {{"file", "File"}, {"edit", "Edit"}, {"muscles", "Muscles"}, {"view", "View"},
                           {"tool", "Tool"}, {"play", "Play"}, {"window", "Window"},   {"help", "Help"}};

std::vector<Action> allActions() {
  std::vector<Action> all;
  for (const std::span<const Action> menu :
       {table::fileActions(), table::editActions(), table::muscleActions(), table::viewActions(), table::toolActions(),
        table::playActions(), table::windowActions(), table::helpActions()}) {
    all.insert(all.end(), menu.begin(), menu.end());
  }
  return all;
}

}  // namespace

std::span<const Menu> menus() { return kMenus; }

std::span<const Action> actions() {
  static const std::vector<Action> all = allActions();
  return all;
}

}  // namespace sinew::app
