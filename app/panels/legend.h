#pragma once  // app/panels/legend.h: what the colours in the picture mean; before-and-after and territory buttons.

#include "app/panels/ui.h"

namespace sinew::app {

/// Held with the mouse or by its key: the character without muscles. Once a frame, for the key as well.
void drawBeforeButton(Ui& ui, float size);
void drawTerritoryButton(Ui& ui, float size);

}  // namespace sinew::app
