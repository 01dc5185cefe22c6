// app/editor/action_table_tool.cpp: the Tool menu.

#include <iterator>
#include <utility>
#include <vector>

#include "app/editor/action_table.h"
#include "app/editor/pose_commands.h"
#include "app/editor/territory.h"
#include "app/viewport/tools/viewport_tools.h"

namespace sinew::app::table {
namespace {

template <std::size_t kIndex>
bool isTool(const State& s) {
  return s.view.tools.tool == static_cast<ToolKind>(kIndex);
}
template <std::size_t kIndex>
void chooseTool(State& s) {
  endTerritoryMode(s.view.tools);  // It takes the clicks that the tool is chosen for.
  setTool(s.view.tools, static_cast<ToolKind>(kIndex));
}

Possible posing(const State& s) {
  return idle(s).also(s.view.tools.tool == ToolKind::kPose, "Choose the Pose tool first");
}
Possible anyPosed(const State& s) { return idle(s).also(isPosed(s), "No joint is turned by hand"); }
Possible jointPosed(const State& s) {
  return idle(s).also(selectedJointIsPosed(s), "Select a joint that is turned by hand first");
}
Possible canPastePose(const State& s) { return idle(s).also(!s.view.copiedPose.empty(), "Copy a pose first"); }
bool holdsPose(const State& s) { return s.open.transport.overrides.from == TurnsFrom::kBindPose; }

bool boxing(const State& s) { return s.view.tools.box.armed; }
void toggleBox(State& s) { armBox(s.view.tools); }
bool pivotsOnAll(const State& s) { return s.view.tools.pivot == GizmoPivot::kCentroid; }
void togglePivot(State& s) { s.view.tools.pivot = pivotsOnAll(s) ? GizmoPivot::kActive : GizmoPivot::kCentroid; }

template <ToolKind kTool>
void dragAtOnce(State& s) {
  startDrag(s.view.tools, kTool);
}

Possible territoryKnown(const State& s) { return editsTerritory(s) ? Possible() : selected(s); }

const Action kOthers[] = {
    {"tool/grab", "Grab", "Move the selected muscle with the pointer, without its handles; a click keeps it", kNone,
     kNone, selected, nullptr, dragAtOnce<ToolKind::kMove>, true},
    {"tool/turn", "Turn", "Turn the selected muscle with the pointer; a click keeps it", kNone, kNone, selected,
     nullptr, dragAtOnce<ToolKind::kRotate>},
    {"tool/size", "Resize", "Scale the selected muscle with the pointer; a click keeps it", kNone, kNone, selected,
     nullptr, dragAtOnce<ToolKind::kScale>},
    {"tool/axes", "Turn handles", "Handles along the world, then the bone, then the muscle", key(GLFW_KEY_X), kNone,
     idle, nullptr, cycleAxes, true},
    {"tool/pivot", "Pivot in the middle", "Several muscles turn about their middle, not about the active one",
     shift(GLFW_KEY_X), kNone, idle, pivotsOnAll, togglePivot},
    {"tool/box-select", "Box select", "Draw a box around muscles: Shift adds, Alt removes. Ctrl+drag does the same",
     shift(GLFW_KEY_B), kNone, idle, boxing, toggleBox},
    {kTerritoryTool.id, kTerritoryTool.label, kTerritoryTool.hint, key(kTerritoryTool.key), kNone, territoryKnown,
     editsTerritory, toggleTerritoryMode, true},
    {"tool/pose-reset-joint", "Reset joint", "Return the selected joint to the clip or the bind pose", alt(GLFW_KEY_P),
     kNone, jointPosed, nullptr, resetJoint, true},
    {"tool/pose-reset", "Reset pose", "Undo every turn made by hand", shift(GLFW_KEY_P), kNone, anyPosed, nullptr,
     resetPose},
    {"tool/pose-mirror", "Mirror pose",
     "Copy the selected joint's side to the other side; with no joint selected, swap left and right",
     ctrlShift(GLFW_KEY_P), kNone, anyPosed, nullptr, mirrorPose},
    {"tool/pose-copy", "Copy pose", "Copy how the joints are turned", kNone, kNone, anyPosed, nullptr, copyPose},
    {"tool/pose-paste", "Paste pose", "Turn the joints as in the copied pose", kNone, kNone, canPastePose, nullptr,
     pastePose},
    {"tool/pose-hold", "Hold turned joints", "Keep turned joints still while the clip moves the others", kNone, kNone,
     idle, holdsPose, toggleHoldPose},
    {"tool/pose-parent", "Parent joint", "Select the parent of the selected joint", key(GLFW_KEY_UP), kNone, posing,
     nullptr, onDocument<selectParentJoint>},
    {"tool/pose-child", "Child joint", "Select the first child of the selected joint", key(GLFW_KEY_DOWN), kNone,
     posing, nullptr, selectChildJoint},
};

/// One row a tool, then the others.
template <std::size_t... kIndices>
std::vector<Action> withTools(std::index_sequence<kIndices...>) {
  std::vector<Action> all{{tools()[kIndices]->id, tools()[kIndices]->label, tools()[kIndices]->hint,
                           tools()[kIndices]->shift ? shift(tools()[kIndices]->key) : key(tools()[kIndices]->key),
                           kNone, idle, isTool<kIndices>, chooseTool<kIndices>}...};
  all.insert(all.end(), std::begin(kOthers), std::end(kOthers));
  return all;
}

}  // namespace

std::span<const Action> toolActions() {
  static const std::vector<Action> all = withTools(std::make_index_sequence<kToolCount>());
  return all;
}

}  // namespace sinew::app::table
