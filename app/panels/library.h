// app/panels/library.h: the tab Library: sets of muscles for this body, each muscle with a picture.
#pragma once

#include "app/panels/panel_ui.h"

namespace sinew::app {

void drawLibrary(PanelUi& ui);

}  // namespace sinew::app
