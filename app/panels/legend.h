// app/panels/legend.h: what the colors in the picture mean; before-and-after and territory buttons.
#pragma once

#include "app/panels/panel_ui.h"

namespace sinew::app {

/// How much of the picture's height, from below, the legend and the line of the mode take; window coordinates.
[[nodiscard]] float legendHeight(PanelUi& ui);
/// Held with the mouse or by its key: the character without muscles. Once a frame, for the key as well.
void drawBeforeButton(PanelUi& ui, float size);
/// The same where there is no room for the button. @param held  by the mouse
void holdBefore(PanelUi& ui, bool held);
void drawTerritoryButton(PanelUi& ui, float size);

}  // namespace sinew::app
