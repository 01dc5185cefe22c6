// app/panels/blending.h: the tab Groups: groups and links as a matrix or a graph.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/panels/field_edit.h"
#include "app/panels/panel_ui.h"

namespace sinew::app {

inline constexpr float kNodeSpacing = 92.0f;  ///< Preferred length of an edge of the graph, design pixels.

/// Initial places of the graph's nodes around the origin, design pixels, y down: linked nodes near each other, none
/// overlapping, deterministic. Fixed steps of springs and repulsion, from a circle (after Fruchterman and Reingold,
/// Software: Practice and Experience 21(11), 1991). @param links  pairs of nodes < count
[[nodiscard]] std::vector<glm::vec2> layoutGraph(int count, std::span<const std::array<int, 2>> links);

/// A place for another node: the first on a spiral from the origin that is far enough from all nodes.
[[nodiscard]] glm::vec2 freePlace(std::span<const glm::vec2> taken);

void drawBlending(PanelUi& ui);
void drawBlendingMatrix(PanelUi& ui, float height);  ///< A triangle of cells, groups by groups.
void drawBlendingGraph(PanelUi& ui, float height);   ///< Nodes and edges.

void groupMenu(PanelUi& ui, int group);  ///< The context menu of a group; between BeginPopup and EndPopup.
/// The field for the new name, at the cursor. Notes itself as blending/rename.
void groupRenameField(PanelUi& ui, float width);
void startGroupRename(EditorState& state, GroupId group);
/// Accepts muscles that are dropped on a group; inside BeginDragDropTarget.
void takeDroppedMuscles(PanelUi& ui, const std::string& group);
/// How much two groups blend, and what a click does.
[[nodiscard]] std::string linkText(const std::string& a, const std::string& b, float amount);
/// How much two groups blend, keys and drivers of that; between BeginPopup and EndPopup.
void linkMenu(PanelUi& ui, int a, int b);
[[nodiscard]] AnimatedField fieldOfLink(const Rig& rig, int a,
                                        int b);                  ///< Without numbers if the groups are not linked.
[[nodiscard]] std::string groupText(const Rig& rig, int group);  ///< "legs: 4 muscles"

}  // namespace sinew::app
