// app/editor/action_table_help.cpp: the Help menu.

#include "app/editor/action_table.h"
#include "app/editor/first_steps.h"
#include "app/editor/muscle_set_commands.h"
#include "app/editor/session.h"

namespace sinew::app::table {
namespace {

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
    {"help/keys", "Keys and mouse", "What every key and every drag does", key(GLFW_KEY_F1), kNone, always, hasSheet,
     toggleSheet},
};

}  // namespace

std::span<const Action> helpActions() { return kHelpActions; }

}  // namespace sinew::app::table
