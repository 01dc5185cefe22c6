// app/panels/dialogs.h: what stands in front of everything else.
#pragma once

#include <initializer_list>

#include "app/panels/panel_ui.h"

namespace sinew::app {

void drawFileDialog(PanelUi& ui);
void drawUnsavedQuestion(PanelUi& ui);
void drawExportDialog(PanelUi& ui);
void drawFarmDialog(PanelUi& ui);
void drawPicturesDialog(PanelUi& ui);
/// Quitting while something is exported.
void drawExportQuestion(PanelUi& ui);
void drawLocateQuestion(PanelUi& ui);
void drawKeepMusclesQuestion(PanelUi& ui);
void drawConflictQuestion(PanelUi& ui);
void drawRecoveryQuestion(PanelUi& ui);
void drawKeySheet(PanelUi& ui);
void drawPreferences(PanelUi& ui);
/// The second page of the preferences: every action with its keys.
void drawKeysPage(PanelUi& ui);
/// Radio buttons; each notes itself as `id` and the keymap's name.
void drawKeymapChoice(PanelUi& ui, const std::string& id);
void drawPalette(PanelUi& ui);

// Rows that the export, farm and pictures dialogs share.
inline constexpr float kExportLabels = 96.0f;  ///< Design pixels: the column of names.
/// Kind, mesh, depth, clips, joints, weights: those that the kind has. @param clips  false: no row for the clips
void drawExportSettings(PanelUi& ui, bool clips);
/// Name and folder of a file to write. @param id  "export/place"  @return whether Enter was pressed in its name
bool drawPlace(PanelUi& ui, const char* id, const char* label, DialogKind kind);
/// Words of which one is chosen, in the row that has been begun. @return the index that was clicked, or -1
int chooseWord(PanelUi& ui, const char* id, std::initializer_list<const char*> words, int chosen);

}  // namespace sinew::app
