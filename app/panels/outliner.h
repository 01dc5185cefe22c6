// app/panels/outliner.h: bones and their muscles as a tree.
#pragma once

#include "app/panels/panel_ui.h"

namespace sinew::app {

void drawOutliner(PanelUi& ui);
/// Once a frame where no row is drawn that a muscle may be dragged from: what is dragged stays beside the pointer.
void keepDraggedShown(PanelUi& ui);

}  // namespace sinew::app
