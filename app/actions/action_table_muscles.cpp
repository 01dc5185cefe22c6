// app/actions/action_table_muscles.cpp: the Muscles menu: whole sets, and the parts of the body they are laid by.

#include "app/actions/action_table.h"
#include "app/actions/body_parts_commands.h"
#include "app/actions/muscle_set_commands.h"

namespace sinew::app::table {
namespace {

bool showsParts(const State& s) { return s.open.bodyParts.shown; }

const Action kActions[] = {
    {"muscles/add-set", "Add muscle set",
     "Give the character the muscles of an athlete, or of an animal, laid by the parts of its body", kNone, kNone, idle,
     nullptr, addMuscleSet},
    {"muscles/body-parts", "Parts of the body",
     "Which bone is the thigh, the forearm and so on: what sets of muscles are laid by, to be corrected", kNone, kNone,
     open, showsParts, toggleBodyParts, true},
};

}  // namespace

std::span<const Action> muscleActions() { return kActions; }

}  // namespace sinew::app::table
