// app/editor/action_table_muscles.cpp: the Muscles menu: whole sets, and the parts of the body they are laid by.

#include "app/editor/action_table.h"
#include "app/editor/body_parts_commands.h"
#include "app/editor/keep_muscles.h"
#include "app/editor/library_commands.h"
#include "app/editor/muscle_set_commands.h"

namespace sinew::app::table {
namespace {

Possible hasMuscles(const State& s) {
  return idle(s).also(!s.document.rig().primitives.empty(), "There is no muscle yet");
}
bool showsLibrary(const State& s) { return s.view.layout.leftShown && s.view.outliner.tab == LeftTab::kLibrary; }
void showLibrary(State& s) {
  s.view.outliner.tab = showsLibrary(s) ? LeftTab::kMuscles : LeftTab::kLibrary;
  s.view.layout.leftShown = true;
}
bool showsParts(const State& s) { return s.open.bodyParts.shown; }

const Action kMuscleActions[] = {
    {"muscles/add-set", "Add muscle set",
     "Give the character the muscles of an athlete, or of an animal, laid by the parts of its body", kNone, kNone, idle,
     nullptr, addMuscleSet},
    {"muscles/body-parts", "Parts of the body",
     "Which bone is the thigh, the forearm and so on: what sets of muscles are laid by, to be corrected", kNone, kNone,
     open, showsParts, toggleBodyParts, true},
    {"muscles/library", "Library", "Muscles of all sets with pictures, to lay them one at a time", kNone, kNone, open,
     showsLibrary, showLibrary},
    {"muscles/save-set", "Save as set...",
     "Keep the selected muscles as a set of your own, to fit them to any character", kNone, kNone, selected, nullptr,
     nameNewSet},
    {"muscles/retarget", "Put on another character...",
     "Open another character with these muscles, each where it belongs on its body", kNone, kNone, hasMuscles, nullptr,
     showRetargetDialog, true},
};

}  // namespace

std::span<const Action> muscleActions() { return kMuscleActions; }

}  // namespace sinew::app::table
