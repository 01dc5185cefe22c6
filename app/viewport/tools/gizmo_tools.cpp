// app/viewport/tools/gizmo_tools.cpp: the tools select, move, rotate and scale.

#include <algorithm>
#include <array>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/document/listed_muscles.h"
#include "app/viewport/tools/status_line.h"
#include "app/viewport/tools/viewport_tools.h"
#include "core/geometry/at.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {

const char* nameOf(GizmoPivot pivot) { return pivot == GizmoPivot::kActive ? "active" : "centroid"; }

std::vector<GizmoCompanion> companionsOf(const Document& document, int active) {
  const Rig& rig = document.rig();
  const Skeleton& skeleton = document.character->skeleton;
  std::vector<GizmoCompanion> companions;
  const std::string& leader = rig.primitives[static_cast<std::size_t>(active)].name;
  for (const PrimitiveId id : document.selection.primitives) {
    const int index = findPrimitive(rig, id);
    if (index < 0 || index == active || isBelly(rig, index)) continue;
    if (!isPickable(document.visibility, rig, skeleton, index)) continue;
    const Primitive& primitive = rig.primitives[static_cast<std::size_t>(index)];
    const auto isTwin = [&](const GizmoCompanion& other) {
      return primitive.mirror == rig.primitives[static_cast<std::size_t>(findPrimitive(rig, other.primitive))].name;
    };
    const bool twinMoves = primitive.mirror == leader || std::ranges::any_of(companions, isTwin);
    if (twinMoves || !skeleton.findBone(primitive.bone)) continue;
    companions.push_back({id, primitive.placement});
  }
  return companions;
}

std::optional<glm::vec3> centroidOf(const Document& document, const Pose& pose, int activeIndex,
                                    const Placement& active, const std::vector<GizmoCompanion>& companions) {
  if (companions.empty()) return std::nullopt;
  const PosedRig& posed = document.posedRig(pose);
  glm::vec3 sum(0.0f);
  int count = 0;
  const auto add = [&](int index, const Placement& placement) {
    const PosedMuscle& muscle = at(posed.muscles, index);
    if (!muscle.usable) return;
    sum += glm::vec3(muscle.carrier * glm::vec4(placement.center, 1.0f));
    ++count;
  };
  add(activeIndex, active);
  for (const GizmoCompanion& companion : companions) {
    const int index = findPrimitive(document.rig(), companion.primitive);
    if (index >= 0) add(index, companion.start);
  }
  if (count < 2) return std::nullopt;
  return sum / static_cast<float>(count);
}

Result<Rig> dragged(const Document& document, const Pose& pose, int active, const DragResult& drag,
                    const std::vector<GizmoCompanion>& companions) {
  Result<Rig> rig = setPlacement(document.rig(), active, drag.placement);
  if (companions.empty()) return rig;
  const PosedRig& posed = document.posedRig(pose);
  for (const GizmoCompanion& companion : companions) {
    const int index = findPrimitive(document.rig(), companion.primitive);
    if (!rig || index < 0) continue;
    const PosedMuscle& muscle = at(posed.muscles, index);
    if (!muscle.usable) continue;
    const Placement placement = draggedAlong(drag.effect, companion.start, muscle.carrier, document.character->height);
    rig = setPlacement(std::move(rig).value(), index, placement);
  }
  return rig;
}

namespace {

/// The active or dragged muscle; nullopt for a sheet (sheet_handles.h), or if this character lacks its bone.
std::optional<GizmoTarget> muscleTarget(const ToolFrame& frame, bool atStart) {
  const Document& document = frame.document();
  const Skeleton& skeleton = document.character->skeleton;
  const Rig& rig = document.rig();
  const bool dragging = frame.tools.owner == PressOwner::kGizmo;
  const int index = dragging ? findPrimitive(rig, frame.tools.gizmoPrimitive) : document.activePrimitive();
  if (index < 0 || isBelly(rig, index)) return std::nullopt;
  const Primitive& primitive = rig.primitives[static_cast<std::size_t>(index)];
  // The placement of the rig, carried by the driven line.
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
  // By HandleKind.
  constexpr std::array<const char*, 6> kVerbs{"Radius of ", "Move ", "Rotate ", "Scale ", "Radius of ", "Shape "};
  return kVerbs[static_cast<std::size_t>(partsOf(handle).kind)] + what;
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
          .icon = icon,
          .handles = handles,
          .whole = whole,
          .picksMuscles = true,
          .target = muscleTarget,
          .beginHandle = beginMuscleDrag,
          .continueHandle = continueMuscleDrag,
          .hover = hoverAt,
          .click = pickMuscle,
          .describe = describeMuscles};
}

}  // namespace

constinit const Tool kSelectTool = gizmoTool("tool/select", "Select", "Click a muscle, or the skin over it", GLFW_KEY_Q,
                                             Icon::kSelect, GizmoMode::kPoles, GizmoHandle::kNone);
constinit const Tool kMoveTool = gizmoTool("tool/move", "Move", "Drag the selected muscle", GLFW_KEY_W, Icon::kMove,
                                           GizmoMode::kMove, GizmoHandle::kMoveCenter);
constinit const Tool kRotateTool = gizmoTool("tool/rotate", "Rotate", "Rotate the selected muscle", GLFW_KEY_E,
                                             Icon::kRotate, GizmoMode::kRotate, GizmoHandle::kRotateScreen);
constinit const Tool kScaleTool = gizmoTool("tool/scale", "Scale", "Change the selected muscle's radii", GLFW_KEY_R,
                                            Icon::kScale, GizmoMode::kScale, GizmoHandle::kScaleUniform);

}  // namespace sinew::app
