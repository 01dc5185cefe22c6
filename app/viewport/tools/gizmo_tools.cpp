// app/viewport/tools/gizmo_tools.cpp: select, move, rotate, scale: handles on the active muscle, clicks that pick.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

#include "app/viewport/tools/gizmo_basis.h"
#include "app/viewport/tools/gizmo_group.h"
#include "app/viewport/tools/status_line.h"
#include "app/viewport/tools/tool.h"

namespace sinew::app {
namespace {

/// The active muscle, or the one being dragged; nothing if its bone is not there.
std::optional<GizmoTarget> muscleTarget(const ToolFrame& frame, bool atStart) {
  const Document& document = frame.document();
  const Skeleton& skeleton = document.character->skeleton;
  const Rig& rig = document.rig();
  const bool dragging = frame.tools.owner == PressOwner::kGizmo;
  const int index = dragging ? findPrimitive(rig, frame.tools.gizmoPrimitive) : document.activePrimitive();
  if (index < 0) return std::nullopt;
  const Primitive& primitive = rig.primitives[static_cast<std::size_t>(index)];
  // The gizmo holds the muscle as it is drawn, on the line as it is driven.
  const PosedMuscle& muscle = document.posedRig(frame.context.pose).muscles[static_cast<std::size_t>(index)];
  if (!muscle.usable || !isPickable(document.visibility, rig, skeleton, index)) return std::nullopt;
  GizmoTarget target{index,
                     primitive.placement,
                     {frame.view, muscle.carrier, document.character->height, frame.context.uiScale, primitive.reach,
                      true, std::nullopt}};
  if (frame.tools.pivot == GizmoPivot::kCentroid) {
    const bool fromStart = atStart && frame.tools.gizmo.drag;
    const Placement& own = fromStart ? frame.tools.gizmo.drag->start : primitive.placement;
    target.context.pivotInWorld = centroidOf(document, frame.context.pose, index, own,
                                             fromStart ? frame.tools.companions : companionsOf(document, index));
  }
  return target;
}

std::string gestureLabel(GizmoHandle handle, const std::string& what) {
  switch (partsOf(handle).kind) {
    case HandleKind::kMove:
      return "Move " + what;
    case HandleKind::kRotate:
      return "Rotate " + what;
    case HandleKind::kScale:
      return "Scale " + what;
    case HandleKind::kShape:
      return "Shape " + what;
    default:
      return "Radius of " + what;
  }
}

bool beginMuscleDrag(ToolFrame& frame, const GizmoTarget& target) {
  ViewportTools& tools = frame.tools;
  const std::string& name = frame.document().rig().primitives[static_cast<std::size_t>(target.primitive)].name;
  tools.gizmoPrimitive = frame.document().idAt(target.primitive);
  tools.companions.clear();
  const HandleKind kind = partsOf(tools.gizmo.hovered).kind;
  if (kind != HandleKind::kPole && kind != HandleKind::kShape) {
    tools.companions = companionsOf(frame.document(), target.primitive);
  }
  const std::string what = tools.companions.empty() ? name : std::to_string(tools.companions.size() + 1) + " muscles";
  frame.document().commands.beginGesture(gestureLabel(tools.gizmo.hovered, what));
  beginDrag(tools.gizmo, tools.gizmo.hovered, target.placement, frame.input.mouse, target.context);
  return true;
}

bool continueMuscleDrag(ToolFrame& frame, const ViewportInput& input) {
  CommandStack& commands = frame.document().commands;
  const std::optional<GizmoTarget> target = muscleTarget(frame, true);
  if (!target || !commands.inGesture()) {
    if (commands.inGesture()) commands.cancelGesture();
    return false;
  }
  const DragResult drag = updateDrag(frame.tools.gizmo, input, target->context);
  if (drag.outcome == DragOutcome::kCanceled) {
    commands.cancelGesture();
    return false;
  }
  Result<Rig> rig = dragged(frame.document(), frame.context.pose, target->primitive, drag, frame.tools.companions);
  if (rig) commands.updateGesture(std::move(rig).value());
  else frame.result.refusal = rig.error();
  if (drag.outcome == DragOutcome::kDragging) return true;
  commands.endGesture();
  return false;
}

void pickMuscle(ToolFrame& frame) {
  ViewportTools& tools = frame.tools;
  pick(frame.document(), tools.hover, frame.input.shift);
  if (frame.input.shift) tools.cycle = {};
  else advance(tools.cycle, tools.hover, frame.context, frame.view, frame.input.mouse);
}

std::string describeMuscles(const ToolFrame& frame) {
  const ViewportHover& hover = frame.tools.hover;
  const std::string under = describe(hover, frame.document());
  if (under.empty()) {
    return statusLine("Background", {"Click clears the selection", "Drag orbits", "Ctrl+drag selects by a box",
                                     "Right+drag pans", "Wheel zooms"});
  }
  const std::string several = countHere(hover);
  const bool cycling = hover.taken >= 0;
  const std::string click = cycling ? "Click again selects " + nextHere(hover, frame.document()) : "Click selects";
  const std::string subject = cycling ? several : under + (several.empty() ? "" : " (" + several + ")");
  return statusLine(subject, {click, "Shift+click adds", "Right+click opens a menu", "Drag orbits",
                              "Ctrl+drag selects by a box", "Right+drag pans", "Wheel zooms"});
}

constexpr Tool gizmoTool(const char* id, const char* label, const char* hint, int key, Icon icon, GizmoMode handles,
                         GizmoHandle whole) {
  return {.id = id,
          .label = label,
          .hint = hint,
          .key = key,
          .shift = false,
          .icon = icon,
          .handles = handles,
          .whole = whole,
          .onSkin = false,
          .picksMuscles = true,
          .target = muscleTarget,
          .beginHandle = beginMuscleDrag,
          .continueHandle = continueMuscleDrag,
          .hover = hoverAt,
          .press = nullptr,
          .drag = nullptr,
          .cancel = nullptr,
          .click = pickMuscle,
          .describe = describeMuscles};
}

}  // namespace

constinit const Tool kSelectTool = gizmoTool("tool/select", "Select", "Click a muscle, or the skin over it", GLFW_KEY_Q,
                                             Icon::kSelect, GizmoMode::kPoles, GizmoHandle::kNone);
constinit const Tool kMoveTool = gizmoTool("tool/move", "Move", "Drag the selected muscle", GLFW_KEY_W, Icon::kMove,
                                           GizmoMode::kMove, GizmoHandle::kMoveCenter);
constinit const Tool kRotateTool = gizmoTool("tool/rotate", "Rotate", "Turn the selected muscle", GLFW_KEY_E,
                                             Icon::kRotate, GizmoMode::kRotate, GizmoHandle::kRotateScreen);
constinit const Tool kScaleTool = gizmoTool("tool/scale", "Scale", "Change the selected muscle's radii", GLFW_KEY_R,
                                            Icon::kScale, GizmoMode::kScale, GizmoHandle::kScaleUniform);

}  // namespace sinew::app
