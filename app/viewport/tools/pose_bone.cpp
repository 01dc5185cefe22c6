// app/viewport/tools/pose_bone.cpp: turning joints by hand.
#include "app/viewport/tools/pose_bone.h"

#include <glm/gtc/quaternion.hpp>

#include "app/document/shown_names.h"
#include "app/viewport/render/picking.h"
#include "app/viewport/tools/status_line.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr float kJointReach = 12.0f;  ///< Design pixels.

std::string nameOfBone(const ViewportContext& context, int bone) {
  return shownBoneName(context.document.character->skeleton, bone);
}

/// The placement that the gizmo drags: only its rotation is used.
Placement atJoint() {
  Placement placement;
  placement.center = glm::vec3(0.0f);
  placement.rotation = glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
  placement.radii = glm::vec3(0.0f);  // No poles: they would lie on the center.
  return placement;
}

}  // namespace

std::optional<JointTarget> jointTarget(const PoseBoneState& state, const ViewportContext& context, const View& view) {
  const int bone = state.bone >= 0 ? state.bone : context.document.selection.bone;
  if (!context.overrides || bone < 0 || bone >= static_cast<int>(context.pose.boneInWorld.size())) return std::nullopt;
  const glm::mat4& boneInWorld = at(context.pose.boneInWorld, bone);
  if (!isFinite(boneInWorld)) return std::nullopt;
  glm::mat3 frame = turnFrame(boneInWorld);
  if (state.bone >= 0) {
    frame = frame * glm::mat3_cast(glm::inverse(state.shown) * state.start);
  }
  glm::mat4 joint(frame);
  joint[3] = boneInWorld[3];
  JointTarget target{bone, atJoint(), {}};
  target.context.view = view;
  target.context.boneInWorld = joint;
  target.context.characterHeight = context.document.character->height;
  target.context.uiScale = context.uiScale;
  return target;
}

void beginTurn(PoseBoneState& state, GizmoState& gizmo, const JointTarget& target, const glm::vec2& pixel,
               const ViewportContext& context) {
  PoseOverrides& overrides = *context.overrides;
  state.bone = target.bone;
  state.before = state.start = overrides.turnOf(target.bone);
  // A joint that is to stand still under the clip starts from how it stands now.
  if (overrides.from == TurnsFrom::kBindPose) {
    state.start = heldTurn(context.document.character->skeleton, context.pose, target.bone);
    overrides.set(target.bone, state.start);
  }
  state.shown = state.start;
  beginDrag(gizmo, gizmo.hovered, target.placement, pixel, target.context);
}

bool continueTurn(PoseBoneState& state, GizmoState& gizmo, const ViewportInput& input, const ViewportContext& context,
                  const View& view) {
  if (context.overrides && state.bone >= 0) state.shown = context.overrides->turnOf(state.bone);
  const std::optional<JointTarget> target = jointTarget(state, context, view);
  if (!target || state.bone < 0 || !gizmo.drag) {
    gizmo.drag.reset();
    state.bone = -1;
    return false;
  }
  const DragResult dragged = updateDrag(gizmo, input, target->context);
  const bool canceled = dragged.outcome == DragOutcome::kCanceled;
  context.overrides->set(state.bone, canceled ? state.before : state.start * dragged.placement.rotation);
  if (dragged.outcome != DragOutcome::kDragging) state.bone = -1;
  return state.bone >= 0;
}

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

void pickJoint(Document& document, const ViewportHover& hover) { document.selection.bone = hover.bone; }

std::string describePosing(const ViewportHover& hover, const ViewportContext& context) {
  const int selected = context.document.selection.bone;
  const std::string turn = selected >= 0 ? "Drag on a ring turns " + nameOfBone(context, selected) : "Drag orbits";
  if (hover.bone < 0) {
    return statusLine("Background",
                      {"Click on a joint or its skin selects it", turn, "Right+drag pans", "Wheel zooms"});
  }
  const std::string act = hover.bone == selected ? "Click keeps it selected" : "Click selects it";
  return statusLine("Joint " + nameOfBone(context, hover.bone), {act, turn, "Right+drag pans", "Wheel zooms"});
}

}  // namespace sinew::app
