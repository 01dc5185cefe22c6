// app/viewport/tools/pose_bone.h: turning joints by hand with the rotation rings. View state: no rig is touched.
#pragma once

#include <optional>
#include <string>

#include "app/viewport/tools/gizmo.h"
#include "app/viewport/tools/select.h"

namespace sinew::app {

/// The pose tool between frames.
struct PoseBoneState {
  int bone = -1;                             ///< Being turned; -1: none.
  glm::quat before{1.0f, 0.0f, 0.0f, 0.0f};  ///< Its turn when the drag began; what Esc goes back to.
  glm::quat start{1.0f, 0.0f, 0.0f, 0.0f};   ///< What the drag's rotation is added to.
  glm::quat shown{1.0f, 0.0f, 0.0f, 0.0f};   ///< Its turn in the pose of this frame.
};

/// What the rings stand around.
struct JointTarget {
  int bone = -1;
  Placement placement;   ///< At the joint; its rotation is the drag's so far, relative to `start`.
  GizmoContext context;  ///< boneInWorld: the joint's turn frame as it was when the drag began, carried by its parent.
};

/// The joint being turned, else the selected one; nothing if there is none or joints cannot be turned.
[[nodiscard]] std::optional<JointTarget> jointTarget(const PoseBoneState& state, const ViewportContext& context,
                                                     const View& view);

/// Starts a drag of the hovered ring.
void beginTurn(PoseBoneState& state, GizmoState& gizmo, const JointTarget& target, const glm::vec2& pixel,
               const ViewportContext& context);

/// One frame of it: the same keys as any gizmo drag. Changes context.overrides. @return false: it has ended.
bool continueTurn(PoseBoneState& state, GizmoState& gizmo, const ViewportInput& input, const ViewportContext& context,
                  const View& view);

/// The bone under a pixel: one seen in x-ray within reach, else the one that moves the skin there. No primitive.
[[nodiscard]] ViewportHover hoverJoint(const ViewportContext& context, const View& view, const glm::vec2& pixel);

/// A click: selects the bone, or none; selected muscles stay so.
void pickJoint(Document& document, const ViewportHover& hover);

/// For the status line while nothing is dragged.
[[nodiscard]] std::string describePosing(const ViewportHover& hover, const ViewportContext& context);

}  // namespace sinew::app
