// app/panels/timeline.h: clip, transport and track.
#pragma once

#include "app/panels/panel_ui.h"

namespace sinew::app {

void drawTimeline(PanelUi& ui);

}  // namespace sinew::app
