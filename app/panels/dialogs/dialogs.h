// app/panels/dialogs/dialogs.h: what stands in front of everything else.
#pragma once

#include "app/panels/shared/panel_ui.h"

namespace sinew::app {

void drawFileDialog(PanelUi& ui);
void drawUnsavedQuestion(PanelUi& ui);
void drawRecoveryQuestion(PanelUi& ui);
void drawKeySheet(PanelUi& ui);
void drawPreferences(PanelUi& ui);
void drawPalette(PanelUi& ui);

}  // namespace sinew::app
