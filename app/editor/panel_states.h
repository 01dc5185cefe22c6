// app/editor/panel_states.h: what outliner, groups and inspector remember between frames.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "sinew/rig/rig.h"

namespace sinew::app {

enum class LeftTab { kMuscles, kGroups };

/// Rows have keys: "m:" and a muscle's identity, or "b:" and a bone's path.
struct OutlinerState {
  LeftTab tab = LeftTab::kMuscles;
  bool onlyWithMuscles = false;  ///< Bones without a muscle on them or below are left out.
  std::set<std::string> folded;  ///< Paths of the bones whose rows are closed.
  bool unattachedFolded = false;
  std::string anchor;  ///< Key of the row where a range of rows starts.
};

/// A group's name being typed.
struct GroupRename {
  GroupId group;  ///< 0 if none.
  std::string text;
  bool appearing = false;
};

struct BlendingState {
  bool asGraph = false;  ///< Nodes and edges instead of the matrix.
  GroupId group;         ///< The chosen one; 0 if none.
  GroupRename rename;
  std::map<GroupId, glm::vec2> places;  ///< Of nodes, design pixels; kept for groups that undo may bring back.
  std::size_t placedDocument = 0;       ///< EditorState::documentsOpened that `places` belongs to.
  glm::vec2 pan{0.0f};                  ///< Design pixels: what the graph's origin is moved by.
  float zoom = 1.0f;
  bool fitWanted = true;  ///< Bring all nodes into the canvas with the next frame.
  GroupId linkFrom;       ///< A link is being dragged from this group; 0 if none.
};

struct InspectorState {
  bool percent = false;        ///< Lengths in per cent of the height, else in character units.
  bool territoryOpen = false;  ///< The list of a default territory's bones is unfolded.
  std::string territoryFilter;
};

/// "Before": the character without muscles while a key or a button is held.
struct BareState {
  bool latched = false;  ///< Switched on from a menu; or the key went down and is not up yet.
  bool byKey = false;
};

/// What belongs to these panels in EditorState.
struct PanelStates {
  OutlinerState outliner;
  BlendingState blending;
  InspectorState inspector;
  BareState bare;
  std::vector<int> highlighted;  ///< Rig indices of muscles that a panel's hover lights up; of this frame.
};

}  // namespace sinew::app
