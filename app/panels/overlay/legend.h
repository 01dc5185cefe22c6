// app/panels/overlay/legend.h: what the colours in the picture mean; before-and-after and territory buttons.
#pragma once

#include "app/panels/shared/panel_ui.h"

namespace sinew::app {

/// Held with the mouse or by its key: the character without muscles. Once a frame, for the key as well.
void drawBeforeButton(PanelUi& ui, float size);
/// The same where there is no room for the button. @param held  by the mouse
void holdBefore(PanelUi& ui, bool held);
void drawTerritoryButton(PanelUi& ui, float size);

}  // namespace sinew::app
