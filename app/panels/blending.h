#pragma once  // app/panels/blending.h: what the two views of the blending graph share.

#include <string>

#include "app/panels/ui.h"

namespace sinew::app {

/// Groups by groups, a triangle of cells; the rest of the panel.
void drawBlendingMatrix(Ui& ui, float height);
/// Nodes and edges.
void drawBlendingGraph(Ui& ui, float height);

/// The right click's menu of a group; between BeginPopup and EndPopup.
void groupMenu(Ui& ui, int group);
/// The name being typed, in the place of the name; the cursor stands where it goes. Notes itself as blending/rename.
void groupRenameField(Ui& ui, float width);
void startGroupRename(EditorState& state, const std::string& group);
/// Right after an item, or a hit of one's own inside BeginDragDropTarget: takes muscles that are dropped on a group.
void takeDroppedMuscles(Ui& ui, const std::string& group);
/// "legs: 4 muscles"
[[nodiscard]] std::string groupText(const Rig& rig, int group);

}  // namespace sinew::app
