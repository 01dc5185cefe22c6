// app/editor/action_table_edit.cpp: the menus Edit and Muscles.
#include "app/editor/action_table.h"
#include "app/editor/animate.h"
#include "app/editor/blending_edit.h"
#include "app/editor/muscle_set_commands.h"
#include "app/editor/open_file.h"
#include "app/editor/symmetry_commands.h"
#include "core/geometry/at.h"

namespace sinew::app::table {
namespace {

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
    {"muscles/retarget", "Put on another character...",
     "Open another character with these muscles, each at its place on the other body", kNone, kNone, anyMuscle, nullptr,
     showRetargetDialog, true},
};

}  // namespace

std::span<const Action> editActions() { return kEditActions; }
std::span<const Action> muscleActions() { return kMuscleActions; }

}  // namespace sinew::app::table
