// app/panels/outliner_row.h: one row of the outliner: name, switches, menu, drag and drop.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/editor/outliner.h"
#include "app/panels/panel_ui.h"

namespace sinew::app {

/// What the rows need, gathered once a frame. The rig is kept alive: a command may replace it while rows are drawn.
struct OutlinerContent {
  std::shared_ptr<const Rig> rig;
  const Skeleton& skeleton;
  std::vector<int> boneOf;
  EffectiveVisibility effective;
  std::vector<bool> territory;  ///< [bones] in the territory that is being edited; empty: none is.
  std::vector<OutlinerRow> rows;
  float rowHeight = 0.0f;
  std::vector<bool> hiddenBones{};       ///< hiddenBones(state)
  std::vector<std::string> boneNames{};  ///< [bones] as they are shown.
  SharedEnds boneEnds;                   ///< What most of boneNames begin and end with; views into them.
  SharedEnds muscleEnds;                 ///< The same of muscles; views into the rig.
};

/// At the cursor; leaves the cursor below it.
void drawOutlinerRow(PanelUi& ui, const OutlinerContent& frame, int position);
// In outliner_menu.cpp.

/// Right click on the last item.
void muscleMenu(PanelUi& ui, const OutlinerContent& frame, int index);
void boneMenu(PanelUi& ui, const OutlinerContent& frame, int bone);

}  // namespace sinew::app
