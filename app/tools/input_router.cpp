// app/tools/input_router.cpp: who gets the mouse.

#include "app/tools/input_router.h"

#include <array>

#include <glm/geometric.hpp>

#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

constexpr float kTremor = 4.0f;  ///< Design pixels a click may move before it is a drag.

/// One frame's work, so that the stages need no long parameter lists.
struct Frame {
  ViewportTools& tools;
  const FrameInput& input;
  const ViewportContext& context;
  View view;
  RouteResult result;

  [[nodiscard]] Document& document() const { return context.document; }
};

// The gizmo's primitive -------------------------------------------------------------------------------------------

struct GizmoTarget {
  int primitive = -1;
  Placement placement;
  GizmoContext context;
};

/// The active primitive, or the one being dragged; nothing if its bone is not there.
std::optional<GizmoTarget> gizmoTarget(const Frame& frame) {
  if (frame.tools.tool == ToolKind::kAddMuscle) return std::nullopt;
  const Rig& rig = frame.document().rig();
  const bool dragging = frame.tools.owner == PressOwner::kGizmo;
  const int index = dragging ? findPrimitive(rig, frame.tools.gizmoPrimitive) : frame.document().activePrimitive();
  if (index < 0) return std::nullopt;
  const Primitive& primitive = rig.primitives[static_cast<std::size_t>(index)];
  const std::optional<int> bone = frame.document().character->skeleton.findBone(primitive.bone);
  if (!bone) return std::nullopt;
  return GizmoTarget{index, primitive.placement,
                     {frame.view, frame.context.pose.boneInWorld[static_cast<std::size_t>(*bone)],
                      frame.document().character->height, frame.context.uiScale}};
}

std::string gestureLabel(GizmoHandle handle, const std::string& primitive) {
  const std::string name = nameOf(handle);
  if (name.starts_with("move")) return "Move " + primitive;
  if (name.starts_with("rotate")) return "Rotate " + primitive;
  if (name.starts_with("scale")) return "Scale " + primitive;
  return "Radius of " + primitive;
}

void beginGizmo(Frame& frame, const GizmoTarget& target) {
  ViewportTools& tools = frame.tools;
  const std::string& name = frame.document().rig().primitives[static_cast<std::size_t>(target.primitive)].name;
  tools.gizmoPrimitive = name;
  frame.document().commands.beginGesture(gestureLabel(tools.gizmo.hovered, name));
  beginDrag(tools.gizmo, tools.gizmo.hovered, target.placement, frame.input.mouse, target.context);
  tools.owner = PressOwner::kGizmo;
}

void endGizmo(ViewportTools& tools) {
  tools.gizmo.drag.reset();
  tools.gizmoPrimitive.clear();
  tools.owner = PressOwner::kNone;
}

void continueGizmo(Frame& frame, const FrameInput& input) {
  CommandStack& commands = frame.document().commands;
  const std::optional<GizmoTarget> target = gizmoTarget(frame);
  if (!target || !commands.inGesture()) {
    if (commands.inGesture()) commands.cancelGesture();
    endGizmo(frame.tools);
    return;
  }
  const DragResult dragged = updateDrag(frame.tools.gizmo, input, target->context);
  if (dragged.outcome == DragOutcome::kCancelled) {
    commands.cancelGesture();
    endGizmo(frame.tools);
    return;
  }
  Result<Rig> rig = setPlacement(frame.document().rig(), target->primitive, dragged.placement);
  if (rig) commands.updateGesture(std::move(rig).value());
  else frame.result.message = rig.error().text();
  if (dragged.outcome == DragOutcome::kDragging) return;
  commands.endGesture();
  endGizmo(frame.tools);
}

// Hover -----------------------------------------------------------------------------------------------------------

/// What was hovered may be gone: the rig or the character has changed since.
void dropStaleHover(ViewportHover& hover, const Document& document) {
  if (hover.primitive >= static_cast<int>(document.rig().primitives.size())) hover.primitive = -1;
  if (hover.bone >= static_cast<int>(document.character->skeleton.bones.size())) hover.bone = -1;
  if (hover.skin && hover.skin->triangle >= static_cast<int>(document.character->mesh.triangles.size())) hover = {};
}

bool pointerInside(const Frame& frame) {
  const glm::vec2 mouse = frame.input.mouse;
  return mouse.x >= 0.0f && mouse.y >= 0.0f && mouse.x < static_cast<float>(frame.context.size.x) &&
         mouse.y < static_cast<float>(frame.context.size.y);
}

bool anyPressed(const FrameInput& input) {
  return input.buttons[0].pressed || input.buttons[1].pressed || input.buttons[2].pressed;
}

void updateHover(Frame& frame, const std::optional<GizmoTarget>& target) {
  ViewportTools& tools = frame.tools;
  if (frame.input.mouseTaken || !pointerInside(frame)) {
    tools.gizmo.hovered = GizmoHandle::kNone;
    tools.hover = {};
    return;
  }
  tools.gizmo.hovered = GizmoHandle::kNone;
  if (target && !frame.input.alt) {
    tools.gizmo.hovered = hitTest(layoutGizmo(tools.gizmo, target->placement, target->context), frame.input.mouse);
  }
  if (tools.gizmo.hovered != GizmoHandle::kNone) {
    tools.hover = {};
    return;
  }
  const bool news = frame.input.mouse != tools.lastPixel || anyPressed(frame.input) || frame.input.wheel != 0.0f ||
                    tools.tool == ToolKind::kAddMuscle;
  if (news) tools.hover = hoverAt(frame.context, frame.view, frame.input.mouse);
}

// Presses ---------------------------------------------------------------------------------------------------------

void take(ViewportTools& tools, PressOwner owner, MouseButton button, const glm::vec2& pixel) {
  tools.owner = owner;
  tools.ownerButton = button;
  tools.pressPixel = pixel;
}

void pressLeft(Frame& frame, const std::optional<GizmoTarget>& target) {
  ViewportTools& tools = frame.tools;
  take(tools, PressOwner::kClick, MouseButton::kLeft, frame.input.mouse);
  if (frame.input.alt) {
    tools.owner = PressOwner::kOrbit;
  } else if (target && tools.gizmo.hovered != GizmoHandle::kNone) {
    beginGizmo(frame, *target);
  } else if (tools.tool == ToolKind::kAddMuscle && tools.hover.skin) {
    const Result<void> begun = beginAddMuscle(tools.addMuscle, frame.context, tools.hover, frame.input.mouse);
    if (begun) tools.owner = PressOwner::kTool;
    else frame.result.message = begun.error().text();
  }
}

void takePress(Frame& frame, const std::optional<GizmoTarget>& target) {
  ViewportTools& tools = frame.tools;
  for (const MouseButton button : {MouseButton::kLeft, MouseButton::kMiddle, MouseButton::kRight}) {
    if (!frame.input.button(button).pressed) continue;
    const glm::vec2 mouse = frame.input.mouse;
    if (frame.input.mouseTaken || !pointerInside(frame)) take(tools, PressOwner::kOutside, button, mouse);
    else if (button == MouseButton::kLeft) pressLeft(frame, target);
    else if (button == MouseButton::kRight || frame.input.shift) take(tools, PressOwner::kPan, button, mouse);
    else take(tools, PressOwner::kOrbit, button, mouse);
    return;
  }
}

// What the owner of the press does with the frame -------------------------------------------------------------------

void continueClick(Frame& frame, bool released) {
  ViewportTools& tools = frame.tools;
  if (glm::length(frame.input.mouse - tools.pressPixel) > kTremor * frame.context.uiScale) {
    orbit(tools.camera, frame.input.mouse - tools.pressPixel, frame.context.size);
    tools.owner = PressOwner::kOrbit;
  } else if (released && tools.tool != ToolKind::kAddMuscle) {
    pick(frame.document(), tools.hover, frame.input.shift);
  }
}

void continueOwner(Frame& frame) {
  ViewportTools& tools = frame.tools;
  // A release that never came (focus lost) counts as one now.
  FrameInput input = frame.input;
  ButtonState& button = input.buttons[static_cast<std::size_t>(tools.ownerButton)];
  button.released = button.released || !button.down;
  const bool released = button.released;
  const glm::vec2 moved = input.mouse - tools.lastPixel;
  switch (tools.owner) {
    case PressOwner::kNone:
    case PressOwner::kOutside: break;
    case PressOwner::kGizmo: continueGizmo(frame, input); break;
    case PressOwner::kTool:
      // An undo from elsewhere ends the gesture under the tool's feet.
      if (!frame.document().commands.inGesture()) tools.addMuscle.drag.reset();
      else updateAddMuscle(tools.addMuscle, input, frame.context, frame.view);
      if (!tools.addMuscle.drag) tools.owner = PressOwner::kNone;
      break;
    case PressOwner::kClick: continueClick(frame, released); break;
    case PressOwner::kOrbit: orbit(tools.camera, moved, frame.context.size); break;
    case PressOwner::kPan: pan(tools.camera, moved, frame.context.size); break;
  }
  if (released) tools.owner = PressOwner::kNone;
}

void wheel(Frame& frame) {
  ViewportTools& tools = frame.tools;
  const bool free = tools.owner == PressOwner::kNone && !frame.input.mouseTaken && pointerInside(frame);
  if (!free || frame.input.wheel == 0.0f) return;
  const std::optional<glm::vec3> point = tools.hover.any() ? std::optional(tools.hover.pointInWorld) : std::nullopt;
  zoomToward(tools.camera, frame.input.wheel, frame.input.mouse, frame.context.size, point);
}

std::string statusOf(const Frame& frame) {
  const ViewportTools& tools = frame.tools;
  if (tools.gizmo.drag || tools.gizmo.hovered != GizmoHandle::kNone) return describe(tools.gizmo);
  if (tools.addMuscle.drag) return "Drag to lay the muscle on the skin: release keeps, Esc cancels";
  if (tools.owner == PressOwner::kOrbit) return "Orbit";
  if (tools.owner == PressOwner::kPan) return "Pan";
  const std::string under = describe(tools.hover, frame.document());
  if (tools.tool == ToolKind::kAddMuscle) {
    if (!tools.hover.skin || tools.hover.bone < 0) return "Add muscle: press on the skin and drag";
    const auto bone = static_cast<std::size_t>(tools.hover.bone);
    return "Press and drag: a muscle grows on " + frame.document().character->skeleton.bones[bone].name;
  }
  if (!under.empty()) return under + ": click selects, Shift adds, drag orbits";
  return "Drag orbits, middle with Shift or right pans, wheel zooms, click on nothing clears the selection";
}

}  // namespace

const char* nameOf(ToolKind tool) {
  constexpr std::array<const char*, 5> names = {"select", "move", "rotate", "scale", "add muscle"};
  return names[static_cast<std::size_t>(tool)];
}

void setTool(ViewportTools& tools, ToolKind tool) {
  if (ownsKeyboard(tools)) return;
  tools.tool = tool;
  switch (tool) {
    case ToolKind::kMove: tools.gizmo.mode = GizmoMode::kMove; break;
    case ToolKind::kRotate: tools.gizmo.mode = GizmoMode::kRotate; break;
    case ToolKind::kScale: tools.gizmo.mode = GizmoMode::kScale; break;
    case ToolKind::kSelect:
    case ToolKind::kAddMuscle: tools.gizmo.mode = GizmoMode::kPoles; break;
  }
}

bool ownsKeyboard(const ViewportTools& tools) { return tools.gizmo.drag || tools.addMuscle.drag; }

void cancelDrags(ViewportTools& tools, Document& document) {
  cancelAddMuscle(tools.addMuscle, document);
  if (tools.gizmo.drag && document.commands.inGesture()) document.commands.cancelGesture();
  endGizmo(tools);
  tools.gizmo.hovered = GizmoHandle::kNone;
  tools.hover = {};
}

RouteResult routeInput(ViewportTools& tools, const FrameInput& input, const ViewportContext& context) {
  advance(tools.camera, input.deltaSeconds);
  Frame frame{tools, input, context, viewOf(tools.camera, context.size), {}};
  dropStaleHover(tools.hover, context.document);
  if (tools.owner == PressOwner::kNone) {
    const std::optional<GizmoTarget> target = gizmoTarget(frame);
    updateHover(frame, target);
    takePress(frame, target);
    wheel(frame);
    // The press is seen where it happened; its first motion belongs to the next frame, unless it is already over.
    if (tools.owner != PressOwner::kNone) tools.lastPixel = input.mouse;
  }
  if (tools.owner != PressOwner::kNone) continueOwner(frame);
  tools.lastPixel = input.mouse;

  frame.view = viewOf(tools.camera, context.size);
  frame.result.view = frame.view;
  if (const std::optional<GizmoTarget> target = gizmoTarget(frame)) {
    frame.result.gizmo = layoutGizmo(tools.gizmo, target->placement, target->context);
    frame.result.gizmoContext = target->context;
  }
  frame.result.status = statusOf(frame);
  frame.result.needsFrame = isMoving(tools.camera) || ownsKeyboard(tools);
  return std::move(frame.result);
}

}  // namespace sinew::app
