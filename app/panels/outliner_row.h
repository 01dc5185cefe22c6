#pragma once  // app/panels/outliner_row.h: one row of the outliner: name, switches, menu, drag and drop.

#include <memory>
#include <vector>

#include "app/panels/outliner_rows.h"
#include "app/panels/ui.h"

namespace sinew::app {

/// What the rows need, gathered once a frame. The rig is kept alive: a command may replace it while rows are drawn.
struct OutlinerFrame {
  std::shared_ptr<const Rig> rig;
  const Skeleton& skeleton;
  std::vector<int> boneOf;
  EffectiveVisibility effective;
  std::vector<bool> territory;  ///< [bones] in the territory that is being edited; empty: none is.
  std::vector<OutlinerRow> rows;
  float rowHeight = 0.0f;
};

/// At the cursor; leaves the cursor below it.
void drawOutlinerRow(Ui& ui, const OutlinerFrame& frame, int position);
/// Once a frame where no row is drawn that a muscle may be dragged from: what is dragged stays beside the pointer.
void keepDraggedShown(Ui& ui);

// In outliner_menu.cpp.

/// Right click on the last item.
void muscleMenu(Ui& ui, const OutlinerFrame& frame, int index);
void boneMenu(Ui& ui, const OutlinerFrame& frame, int bone);

}  // namespace sinew::app
