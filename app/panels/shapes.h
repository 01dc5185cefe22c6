// app/panels/shapes.h: the tab Shapes: a slider for each morph target of the character.
#pragma once

#include "app/panels/panel_ui.h"

namespace sinew::app {

void drawShapes(PanelUi& ui);

}  // namespace sinew::app
