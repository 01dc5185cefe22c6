// app/panels/dialogs.h: what stands in front of everything else.
#pragma once

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

}  // namespace sinew::app
