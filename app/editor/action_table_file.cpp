// app/editor/action_table_file.cpp: the File menu.

#include "app/editor/action_table.h"
#include "app/editor/clip_commands.h"
#include "app/editor/export_commands.h"
#include "app/editor/picture_commands.h"
#include "app/editor/pictures_commands.h"

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

}  // namespace

std::span<const Action> fileActions() { return kFileActions; }

}  // namespace sinew::app::table
