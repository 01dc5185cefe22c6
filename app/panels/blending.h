// app/panels/blending.h: groups and links as a matrix or a graph.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/panels/panel_ui.h"

namespace sinew::app {

// Where the nodes of the blending graph stand when nobody has placed them.

inline constexpr float kNodeSpacing = 92.0f;  ///< Length an edge strives for, design pixels.

/// Places for all nodes around the origin, design pixels, y down: linked ones near each other, none on another, the
/// same graph always the same. Springs and repulsion from a circle, a fixed number of steps (after Fruchterman and
/// Reingold, Software: Practice and Experience 21(11), 1991).
/// @param links  pairs of nodes < count
[[nodiscard]] std::vector<glm::vec2> layoutGraph(int count, std::span<const std::array<int, 2>> links);

/// A place for one more: the nearest to the origin on a spiral that keeps its distance from all.
[[nodiscard]] glm::vec2 freePlace(std::span<const glm::vec2> taken);

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
