// app/editor/action_table.cpp: the table of actions; the rows of the menus File, Window and Help.
#include "app/editor/action_table.h"

#include <vector>

#include "app/editor/clip_commands.h"
#include "app/editor/export_commands.h"
#include "app/editor/muscle_set_commands.h"
#include "app/editor/picture_commands.h"
#include "app/editor/session.h"

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

}  // namespace

std::span<const Action> fileActions() { return kFileActions; }
std::span<const Action> windowActions() { return kWindowActions; }
std::span<const Action> helpActions() { return kHelpActions; }

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
