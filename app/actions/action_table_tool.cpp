// app/actions/action_table_tool.cpp: the Tool menu.

#include "app/actions/action_table.h"
#include "app/editor/pose_commands.h"
#include "app/editor/territory.h"

namespace sinew::app::table {
namespace {

template <ToolKind kTool>
bool isTool(const State& s) {
  return s.tools.tool == kTool;
}
template <ToolKind kTool>
void chooseTool(State& s) {
  endTerritoryMode(s);  // It takes the clicks that the tool is chosen for.
  setTool(s.tools, kTool);
}

bool posing(const State& s) { return idle(s) && s.tools.tool == ToolKind::kPose; }
bool anyPosed(const State& s) { return idle(s) && isPosed(s); }
bool jointPosed(const State& s) { return idle(s) && selectedJointIsPosed(s); }
bool canPastePose(const State& s) { return idle(s) && !s.copiedPose.empty(); }
bool holdsPose(const State& s) { return s.transport.overrides.from == TurnsFrom::kBindPose; }

bool boxing(const State& s) { return s.tools.box.armed; }
void toggleBox(State& s) { armBox(s.tools); }
bool pivotsOnAll(const State& s) { return s.tools.pivot == GizmoPivot::kCentroid; }
void togglePivot(State& s) { s.tools.pivot = pivotsOnAll(s) ? GizmoPivot::kActive : GizmoPivot::kCentroid; }

template <ToolKind kTool>
void dragAtOnce(State& s) {
  startDrag(s.tools, kTool);
}

bool territoryKnown(const State& s) { return selected(s) || editsTerritory(s); }

const Action kActions[] = {
    {"tool/select", "Select", "Click a muscle, or the skin over it", key(GLFW_KEY_Q), kNone, idle,
     isTool<ToolKind::kSelect>, chooseTool<ToolKind::kSelect>},
    {"tool/move", "Move", "Drag the selected muscle", key(GLFW_KEY_W), kNone, idle, isTool<ToolKind::kMove>,
     chooseTool<ToolKind::kMove>},
    {"tool/rotate", "Rotate", "Turn the selected muscle", key(GLFW_KEY_E), kNone, idle, isTool<ToolKind::kRotate>,
     chooseTool<ToolKind::kRotate>},
    {"tool/scale", "Scale", "Change the selected muscle's radii", key(GLFW_KEY_R), kNone, idle,
     isTool<ToolKind::kScale>, chooseTool<ToolKind::kScale>},
    {"tool/add-muscle", "Add muscle", "Press on the skin and drag: a muscle grows there", key(GLFW_KEY_M), kNone, idle,
     isTool<ToolKind::kAddMuscle>, chooseTool<ToolKind::kAddMuscle>},
    {"tool/pose", "Pose", "Click a joint and turn it with the rings, to judge muscles in any attitude", key(GLFW_KEY_P),
     kNone, idle, isTool<ToolKind::kPose>, chooseTool<ToolKind::kPose>},
    {"tool/grab", "Grab", "Move the selected muscle with the pointer, without its handles; a click keeps it", kNone,
     kNone, selected, nullptr, dragAtOnce<ToolKind::kMove>, true},
    {"tool/turn", "Turn", "Turn the selected muscle with the pointer; a click keeps it", kNone, kNone, selected,
     nullptr, dragAtOnce<ToolKind::kRotate>},
    {"tool/size", "Resize", "Scale the selected muscle with the pointer; a click keeps it", kNone, kNone, selected,
     nullptr, dragAtOnce<ToolKind::kScale>},
    {"tool/axes", "Next axes", "Handles along the world, the bone or the muscle", key(GLFW_KEY_X), kNone, idle, nullptr,
     cycleAxes, true},
    {"tool/pivot", "Pivot in the middle", "Several muscles turn about their middle, not about the active one",
     shift(GLFW_KEY_X), kNone, idle, pivotsOnAll, togglePivot},
    {"tool/box-select", "Box select", "Draw a box around muscles: Shift adds, Alt takes away. Ctrl+drag does the same",
     shift(GLFW_KEY_B), kNone, idle, boxing, toggleBox},
    {"tool/territory", "Edit territory", "Click bones: the skin of which the selected muscle may move", key(GLFW_KEY_B),
     kNone, territoryKnown, editsTerritory, toggleTerritoryMode, true},
    {"tool/pose-reset-joint", "Reset joint", "The selected joint goes back to the clip, or the bind pose",
     alt(GLFW_KEY_P), kNone, jointPosed, nullptr, resetJoint, true},
    {"tool/pose-reset", "Reset pose", "Take back every turned joint", shift(GLFW_KEY_P), kNone, anyPosed, nullptr,
     resetPose},
    {"tool/pose-mirror", "Mirror pose",
     "The selected joint's side goes to the other side; without one, left and right change places",
     ctrlShift(GLFW_KEY_P), kNone, anyPosed, nullptr, mirrorPose},
    {"tool/pose-copy", "Copy pose", "Remember how the joints are turned", kNone, kNone, anyPosed, nullptr, copyPose},
    {"tool/pose-paste", "Paste pose", "Turn the joints as they were copied", kNone, kNone, canPastePose, nullptr,
     pastePose},
    {"tool/pose-hold", "Turned joints stand still", "They stay as they are while the clip moves the others", kNone,
     kNone, idle, holdsPose, toggleHoldPose},
    {"tool/pose-parent", "Joint above", "Select the joint that carries the selected one", key(GLFW_KEY_UP), kNone,
     posing, nullptr, selectParentJoint},
    {"tool/pose-child", "Joint below", "Select the first joint that hangs on the selected one", key(GLFW_KEY_DOWN),
     kNone, posing, nullptr, selectChildJoint},
};

}  // namespace

std::span<const Action> toolActions() { return kActions; }

}  // namespace sinew::app::table
