// app/panels/outliner_row.h: one row of the outliner: name, switches, menu, drag and drop.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/editor/outliner.h"
#include "app/panels/panel_ui.h"

namespace sinew::app {

/// Data of the rows, gathered once a frame. It keeps the rig, which a command may replace while rows are drawn.
struct OutlinerContent {
  std::shared_ptr<const Rig> rig;
  const Skeleton& skeleton;
  std::vector<int> boneOf;
  EffectiveVisibility effective;
  std::vector<bool> territory;  ///< [bones] in the territory that is being edited; empty: none.
  std::vector<OutlinerRow> rows;
  float rowHeight = 0.0f;
  std::vector<bool> hiddenBones{};       ///< hiddenBones(state)
  std::vector<std::string> boneNames{};  ///< [bones] as they are shown.
  SharedEnds boneEnds;                   ///< Shared beginning and end of boneNames; views into them.
  SharedEnds muscleEnds;                 ///< The same for muscles; views into the rig.
};

/// At the cursor, which moves below it.
void drawOutlinerRow(PanelUi& ui, const OutlinerContent& frame, int position);

/// Menus of a right click on the last item; in outliner.cpp.
void muscleMenu(PanelUi& ui, const OutlinerContent& frame, int index);
void boneMenu(PanelUi& ui, const OutlinerContent& frame, int bone);

}  // namespace sinew::app
