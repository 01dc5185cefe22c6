// app/viewport/tools/pose_tool.cpp: the pose tool: rings on the selected joint, clicks that choose joints.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/document/shown_names.h"
#include "app/viewport/tools/tool.h"

namespace sinew::app {
namespace {

std::optional<GizmoTarget> ringsOnJoint(const ToolFrame& frame, bool) {
  const std::optional<JointTarget> joint = jointTarget(frame.tools.pose, frame.context, frame.view);
  if (!joint) return std::nullopt;
  return GizmoTarget{-1, joint->placement, joint->context};
}

bool beginRing(ToolFrame& frame, const GizmoTarget&) {
  const std::optional<JointTarget> joint = jointTarget(frame.tools.pose, frame.context, frame.view);
  if (!joint) return false;
  beginTurn(frame.tools.pose, frame.tools.gizmo, *joint, frame.input.mouse, frame.context);
  return true;
}

bool continueRing(ToolFrame& frame, const ViewportInput& input) {
  const int joint = frame.tools.pose.bone;
  if (continueTurn(frame.tools.pose, frame.tools.gizmo, input, frame.context, frame.view)) return true;
  if (joint >= 0 && frame.context.overrides) {
    const std::string name = shownBoneName(frame.document().character->skeleton, joint);
    frame.document().commands.applyPose("Turn " + name, *frame.context.overrides);
  }
  return false;
}

void chooseJoint(ToolFrame& frame) { pickJoint(frame.document(), frame.tools.hover); }

std::string describeJoint(const ToolFrame& frame) { return describePosing(frame.tools.hover, frame.context); }

}  // namespace

constinit const Tool kPoseTool{
    .id = "tool/pose",
    .label = "Pose",
    .hint = "Click a joint and turn it with the rings, to see muscles in any pose",
    .key = GLFW_KEY_P,
    .shift = false,
    .icon = Icon::kPose,
    .handles = GizmoMode::kRotate,
    .whole = GizmoHandle::kNone,
    .onSkin = false,
    .picksMuscles = false,
    .target = ringsOnJoint,
    .beginHandle = beginRing,
    .continueHandle = continueRing,
    .hover = hoverJoint,
    .press = nullptr,
    .drag = nullptr,
    .cancel = nullptr,
    .click = chooseJoint,
    .describe = describeJoint,
};

}  // namespace sinew::app
