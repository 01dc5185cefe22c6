// app/panels/blending.h: groups and links as a matrix or a graph.
#pragma once

#include <string>

#include "app/panels/panel_ui.h"

namespace sinew::app {

/// The panel "Groups".
void drawBlending(PanelUi& ui);

/// Groups by groups, a triangle of cells; the rest of the panel.
void drawBlendingMatrix(PanelUi& ui, float height);
/// Nodes and edges.
void drawBlendingGraph(PanelUi& ui, float height);

/// The right click's menu of a group; between BeginPopup and EndPopup.
void groupMenu(PanelUi& ui, int group);
/// The name being typed, in the place of the name; the cursor stands where it goes. Notes itself as blending/rename.
void groupRenameField(PanelUi& ui, float width);
void startGroupRename(EditorState& state, GroupId group);
/// Right after an item, or a hit of one's own inside BeginDragDropTarget: takes muscles that are dropped on a group.
void takeDroppedMuscles(PanelUi& ui, const std::string& group);
/// "legs: 4 muscles"
[[nodiscard]] std::string groupText(const Rig& rig, int group);

}  // namespace sinew::app
