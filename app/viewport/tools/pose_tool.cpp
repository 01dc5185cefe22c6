// app/viewport/tools/pose_tool.cpp: the pose tool: rings on the selected joint, clicks that select joints.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glm/gtc/quaternion.hpp>

#include "app/document/shown_names.h"
#include "app/viewport/render/picking.h"
#include "app/viewport/tools/status_line.h"
#include "app/viewport/tools/viewport_tools.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr float kJointReach = 12.0f;  ///< Design pixels.

std::string nameOfBone(const ToolFrame& frame, int bone) {
  return shownBoneName(frame.document().character->skeleton, bone);
}

/// Rings on the joint being rotated, else on the selected one, in its frame at the start of the drag, carried by its
/// parent. The rotation of the placement is that of the drag, relative to PoseBoneState::start.
std::optional<GizmoTarget> ringsOnJoint(const ToolFrame& frame, bool) {
  const PoseBoneState& state = frame.tools.pose;
  const ViewportContext& context = frame.context;
  const int bone = state.bone >= 0 ? state.bone : context.document.selection.bone;
  if (!context.overrides || bone < 0 || bone >= static_cast<int>(context.pose.boneInWorld.size())) return std::nullopt;
  const glm::mat4& boneInWorld = at(context.pose.boneInWorld, bone);
  if (!isFinite(boneInWorld)) return std::nullopt;
  glm::mat3 axes = turnFrame(boneInWorld);
  if (state.bone >= 0) axes = axes * glm::mat3_cast(glm::inverse(state.shown) * state.start);
  GizmoTarget target;
  target.placement.center = glm::vec3(0.0f);
  target.placement.rotation = glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
  target.placement.radii = glm::vec3(0.0f);  // Poles on the center are left out.
  target.context.view = frame.view;
  target.context.boneInWorld = glm::mat4(axes);
  target.context.boneInWorld[3] = boneInWorld[3];
  target.context.characterHeight = context.document.character->height;
  target.context.uiScale = context.uiScale;
  return target;
}

bool beginRing(ToolFrame& frame, const GizmoTarget& target) {
  PoseBoneState& state = frame.tools.pose;
  PoseOverrides& overrides = *frame.context.overrides;
  if (state.bone < 0) state.bone = frame.document().selection.bone;
  state.before = state.start = overrides.turnOf(state.bone);
  // A joint that does not follow the clip starts from its current rotation.
  if (overrides.from == TurnsFrom::kBindPose) {
    state.start = heldTurn(frame.document().character->skeleton, frame.context.pose, state.bone);
    overrides.set(state.bone, state.start);
  }
  state.shown = state.start;
  beginDrag(frame.tools.gizmo, frame.tools.gizmo.hovered, target.placement, frame.input.mouse, target.context);
  return true;
}

bool continueRing(ToolFrame& frame, const ViewportInput& input) {
  PoseBoneState& state = frame.tools.pose;
  GizmoState& gizmo = frame.tools.gizmo;
  PoseOverrides* const overrides = frame.context.overrides;
  const int joint = state.bone;
  if (overrides && joint >= 0) state.shown = overrides->turnOf(joint);
  const std::optional<GizmoTarget> target = ringsOnJoint(frame, true);
  if (!target || joint < 0 || !gizmo.drag) {
    gizmo.drag.reset();
  } else {
    const DragResult dragged = updateDrag(gizmo, input, target->context);
    const bool canceled = dragged.outcome == DragOutcome::kCanceled;
    overrides->set(joint, canceled ? state.before : state.start * dragged.placement.rotation);
    if (dragged.outcome == DragOutcome::kDragging) return true;
  }
  state.bone = -1;
  if (joint >= 0 && overrides) {
    frame.document().commands.applyPose("Turn " + nameOfBone(frame, joint), *overrides);
  }
  return false;
}

/// The bone near a pixel in x-ray, else the one that moves the skin there. No primitive.
ViewportHover hoverJoint(const ViewportContext& context, const View& view, const glm::vec2& pixel) {
  ViewportHover hover = hoverAt(context, view, pixel);
  hover.primitive = -1;
  const Skeleton& skeleton = context.document.character->skeleton;
  if (const auto hit =
          pickBone(pixel, view, skeleton, context.pose, kJointReach * context.uiScale, context.hiddenBones)) {
    hover.bone = hit->bone;
    if (!hover.skin) hover.pointInWorld = glm::vec3(at(context.pose.boneInWorld, hit->bone)[3]);
  }
  return hover;
}

/// Selected muscles stay selected.
void pickJoint(ToolFrame& frame) { frame.document().selection.bone = frame.tools.hover.bone; }

std::string describePosing(const ToolFrame& frame) {
  const int selected = frame.document().selection.bone;
  const int hovered = frame.tools.hover.bone;
  const std::string drag = selected >= 0 ? "Drag on a ring turns " + nameOfBone(frame, selected) : "Drag orbits";
  if (hovered < 0) {
    return statusLine("Background",
                      {"Click on a joint or its skin selects it", drag, "Right+drag pans", "Wheel zooms"});
  }
  const std::string click = hovered == selected ? "Click keeps it selected" : "Click selects it";
  return statusLine("Joint " + nameOfBone(frame, hovered), {click, drag, "Right+drag pans", "Wheel zooms"});
}

}  // namespace

constinit const Tool kPoseTool{
    .id = "tool/pose",
    .label = "Pose",
    .hint = "Click a joint and rotate it with the rings to see muscles in any pose",
    .key = GLFW_KEY_P,
    .icon = Icon::kPose,
    .handles = GizmoMode::kRotate,
    .target = ringsOnJoint,
    .beginHandle = beginRing,
    .continueHandle = continueRing,
    .hover = hoverJoint,
    .click = pickJoint,
    .describe = describePosing,
};

}  // namespace sinew::app
