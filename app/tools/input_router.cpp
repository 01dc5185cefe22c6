// app/tools/input_router.cpp: who gets the mouse.

#include "app/tools/input_router.h"

#include <array>
#include <utility>

#include <glm/geometric.hpp>

#include "app/tools/gizmo_frame.h"

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
  int primitive = -1;  ///< -1: a joint's rings, of the pose tool.
  Placement placement;
  GizmoContext context;
};

/// The active primitive, or the one being dragged; nothing if its bone is not there.
/// @param atStart  for a drag in progress: where the handles stood when it began, in this frame's pose.
std::optional<GizmoTarget> gizmoTarget(const Frame& frame, bool atStart = false) {
  if (frame.tools.tool == ToolKind::kAddMuscle || frame.tools.pickBones) return std::nullopt;
  if (frame.tools.tool == ToolKind::kPose) {
    const std::optional<JointTarget> joint = jointTarget(frame.tools.pose, frame.context, frame.view);
    if (!joint) return std::nullopt;
    return GizmoTarget{-1, joint->placement, joint->context};
  }
  const Rig& rig = frame.document().rig();
  const bool dragging = frame.tools.owner == PressOwner::kGizmo;
  const int index = dragging ? findPrimitive(rig, frame.tools.gizmoPrimitive) : frame.document().activePrimitive();
  if (index < 0) return std::nullopt;
  const Primitive& primitive = rig.primitives[static_cast<std::size_t>(index)];
  const std::optional<int> bone = frame.document().character->skeleton.findBone(primitive.bone);
  if (!bone) return std::nullopt;
  const Visibility& visibility = frame.document().visibility;
  if (!isPickable(visibility, rig, frame.document().character->skeleton, index)) return std::nullopt;
  GizmoTarget target{index,
                     primitive.placement,
                     {frame.view, frame.context.pose.boneInWorld[static_cast<std::size_t>(*bone)],
                      frame.document().character->height, frame.context.uiScale, std::nullopt}};
  if (frame.tools.pivot == GizmoPivot::kCentroid) {
    const bool fromStart = atStart && frame.tools.gizmo.drag;
    const Placement& own = fromStart ? frame.tools.gizmo.drag->start : primitive.placement;
    target.context.pivotInWorld =
        centroidOf(frame.document(), frame.context.pose, primitive.bone, own,
                   fromStart ? frame.tools.companions : companionsOf(frame.document(), index));
  }
  return target;
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
  if (tools.tool == ToolKind::kPose) {
    const std::optional<JointTarget> joint = jointTarget(tools.pose, frame.context, frame.view);
    if (!joint) return;
    beginTurn(tools.pose, tools.gizmo, *joint, frame.input.mouse, frame.context);
    tools.owner = PressOwner::kGizmo;
    return;
  }
  const std::string& name = frame.document().rig().primitives[static_cast<std::size_t>(target.primitive)].name;
  tools.gizmoPrimitive = name;
  tools.companions.clear();
  if (partsOf(tools.gizmo.hovered).kind != HandleKind::kPole) {
    tools.companions = companionsOf(frame.document(), target.primitive);
  }
  const std::string what = tools.companions.empty() ? name : std::to_string(tools.companions.size() + 1) + " muscles";
  frame.document().commands.beginGesture(gestureLabel(tools.gizmo.hovered, what));
  beginDrag(tools.gizmo, tools.gizmo.hovered, target.placement, frame.input.mouse, target.context);
  tools.owner = PressOwner::kGizmo;
}

void endGizmo(ViewportTools& tools) {
  tools.gizmo.drag.reset();
  tools.gizmoPrimitive.clear();
  tools.companions.clear();
  tools.buttonless = false;
  tools.pose.bone = -1;
  tools.owner = PressOwner::kNone;
}

void continueGizmo(Frame& frame, const FrameInput& input) {
  if (frame.tools.tool == ToolKind::kPose) {
    if (!continueTurn(frame.tools.pose, frame.tools.gizmo, input, frame.context, frame.view)) endGizmo(frame.tools);
    return;
  }
  CommandStack& commands = frame.document().commands;
  const std::optional<GizmoTarget> target = gizmoTarget(frame, true);
  if (!target || !commands.inGesture()) {
    if (commands.inGesture()) commands.cancelGesture();
    endGizmo(frame.tools);
    return;
  }
  const DragResult drag = updateDrag(frame.tools.gizmo, input, target->context);
  if (drag.outcome == DragOutcome::kCancelled) {
    commands.cancelGesture();
    endGizmo(frame.tools);
    return;
  }
  Result<Rig> rig = dragged(frame.document(), frame.context.pose, target->primitive, drag, frame.tools.companions);
  if (rig) commands.updateGesture(std::move(rig).value());
  else frame.result.message = rig.error().text();
  if (drag.outcome == DragOutcome::kDragging) return;
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
  const auto look = tools.tool == ToolKind::kPose && !tools.pickBones ? hoverJoint : hoverAt;
  if (news) tools.hover = look(frame.context, frame.view, frame.input.mouse);
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
  const bool overHandle = target && tools.gizmo.hovered != GizmoHandle::kNone;
  if (tools.box.armed || (frame.input.ctrl && !overHandle && !tools.pickBones)) {
    tools.box = {false, BoxDrag{frame.input.mouse, frame.input.mouse, BoxMode::kReplace}};
    tools.owner = PressOwner::kBox;
  } else if (frame.input.alt) {
    tools.owner = PressOwner::kOrbit;
  } else if (overHandle) {
    beginGizmo(frame, *target);
  } else if (tools.tool == ToolKind::kAddMuscle && !tools.pickBones && tools.hover.skin) {
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

/// The handle that a drag without a press takes: the whole, as seen.
GizmoHandle wholeHandle(ToolKind tool) {
  switch (tool) {
    case ToolKind::kMove:
      return GizmoHandle::kMoveCenter;
    case ToolKind::kRotate:
      return GizmoHandle::kRotateScreen;
    case ToolKind::kScale:
      return GizmoHandle::kScaleUniform;
    default:
      return GizmoHandle::kNone;
  }
}

void takeWantedDrag(Frame& frame, const std::optional<GizmoTarget>& target) {
  ViewportTools& tools = frame.tools;
  const bool wanted = std::exchange(tools.dragWanted, false);
  const GizmoHandle handle = wholeHandle(tools.tool);
  if (!wanted || !target || handle == GizmoHandle::kNone || !pointerInside(frame)) return;
  tools.gizmo.hovered = handle;
  take(tools, PressOwner::kGizmo, MouseButton::kLeft, frame.input.mouse);
  beginGizmo(frame, *target);
  tools.buttonless = true;
}

// What the owner of the press does with the frame -------------------------------------------------------------------

void continueClick(Frame& frame, bool released) {
  ViewportTools& tools = frame.tools;
  if (glm::length(frame.input.mouse - tools.pressPixel) > kTremor * frame.context.uiScale) {
    orbit(tools.camera, frame.input.mouse - tools.pressPixel, frame.context.size);
    tools.owner = PressOwner::kOrbit;
  } else if (released && tools.pickBones) {
    frame.result.pickedBone = tools.hover.bone;
  } else if (released && tools.tool == ToolKind::kPose) {
    pickJoint(frame.document(), tools.hover);
  } else if (released && tools.tool != ToolKind::kAddMuscle) {
    pick(frame.document(), tools.hover, frame.input.shift);
  }
}

/// Pulls the box open. What stayed as small as a click picks as a click does, and adds.
void continueBox(Frame& frame, const FrameInput& input, bool released) {
  ViewportTools& tools = frame.tools;
  if (input.keyPressed(Key::kEscape) || input.button(MouseButton::kRight).pressed) {
    tools.box.drag.reset();
    tools.owner = PressOwner::kOutside;
    return;
  }
  BoxDrag& box = *tools.box.drag;
  box.to = input.mouse;
  box.mode = input.alt ? BoxMode::kRemove : (input.shift ? BoxMode::kAdd : BoxMode::kReplace);
  if (!released) return;
  const bool click = glm::length(box.to - box.from) <= kTremor * frame.context.uiScale;
  if (click) pick(frame.document(), tools.hover, true);
  else selectBox(frame.context, frame.view, box);
  tools.box.drag.reset();
}

void continueOwner(Frame& frame) {
  ViewportTools& tools = frame.tools;
  // A release that never came (focus lost) counts as one now.
  FrameInput input = frame.input;
  ButtonState& button = input.buttons[static_cast<std::size_t>(tools.ownerButton)];
  if (tools.buttonless) button = {true, false, button.pressed, false};  // A click ends it.
  button.released = button.released || !button.down;
  const bool released = button.released;
  const glm::vec2 moved = input.mouse - tools.lastPixel;
  switch (tools.owner) {
    case PressOwner::kNone:
    case PressOwner::kOutside:
      break;
    case PressOwner::kGizmo:
      continueGizmo(frame, input);
      break;
    case PressOwner::kTool:
      // An undo from elsewhere ends the gesture under the tool's feet.
      if (!frame.document().commands.inGesture()) tools.addMuscle.drag.reset();
      else updateAddMuscle(tools.addMuscle, input, frame.context, frame.view);
      if (!tools.addMuscle.drag) tools.owner = PressOwner::kNone;
      break;
    case PressOwner::kBox:
      continueBox(frame, input, released);
      break;
    case PressOwner::kClick:
      continueClick(frame, released);
      break;
    case PressOwner::kOrbit:
      orbit(tools.camera, moved, frame.context.size);
      break;
    case PressOwner::kPan:
      pan(tools.camera, moved, frame.context.size);
      break;
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
  if (tools.addMuscle.drag) return "Drag along the skin: release keeps, Esc cancels; the pose is held while you draw";
  if (tools.box.drag) return "Box: release selects what it touches, Shift adds, Alt takes away, Esc cancels";
  if (tools.box.armed) return "Draw a box around muscles: Shift adds, Alt takes away, Esc ends";
  if (tools.owner == PressOwner::kOrbit) return "Orbit";
  if (tools.owner == PressOwner::kPan) return "Pan";
  const std::string under = describe(tools.hover, frame.document());
  if (tools.pickBones) {
    const std::string ends = ", Esc ends the mode";
    if (tools.hover.bone < 0) return "Territory: click a bone, or the skin that follows it" + ends;
    const auto bone = static_cast<std::size_t>(tools.hover.bone);
    return "Click: " + frame.document().character->skeleton.bones[bone].name + " joins or leaves the territory" + ends;
  }
  if (tools.tool == ToolKind::kAddMuscle) {
    if (!tools.hover.skin || tools.hover.bone < 0) return "Add muscle: press on the skin and drag";
    const auto bone = static_cast<std::size_t>(tools.hover.bone);
    return "Press and drag: a muscle grows on " + frame.document().character->skeleton.bones[bone].name;
  }
  if (tools.tool == ToolKind::kPose) return describePosing(tools.hover, frame.context);
  if (!under.empty()) return under + ": click selects, Shift adds, drag orbits, Ctrl+drag boxes";
  return "Drag orbits, Ctrl+drag selects by a box, right pans, wheel zooms, click on nothing clears the selection";
}

}  // namespace

const char* nameOf(ToolKind tool) {
  constexpr std::array<const char*, 6> names = {"select", "move", "rotate", "scale", "add muscle", "pose"};
  return names[static_cast<std::size_t>(tool)];
}

void setTool(ViewportTools& tools, ToolKind tool) {
  if (ownsKeyboard(tools)) return;
  tools.tool = tool;
  switch (tool) {
    case ToolKind::kMove:
      tools.gizmo.mode = GizmoMode::kMove;
      break;
    case ToolKind::kPose:
    case ToolKind::kRotate:
      tools.gizmo.mode = GizmoMode::kRotate;
      break;
    case ToolKind::kScale:
      tools.gizmo.mode = GizmoMode::kScale;
      break;
    case ToolKind::kSelect:
    case ToolKind::kAddMuscle:
      tools.gizmo.mode = GizmoMode::kPoles;
      break;
  }
}

void startDrag(ViewportTools& tools, ToolKind tool) {
  if (ownsKeyboard(tools)) return;
  setTool(tools, tool);
  tools.dragWanted = true;
}

void armBox(ViewportTools& tools) {
  if (!ownsKeyboard(tools)) tools.box.armed = !tools.box.armed;
}

bool ownsKeyboard(const ViewportTools& tools) {
  return tools.gizmo.drag || tools.addMuscle.drag || tools.box.drag || tools.box.armed;
}

void cancelDrags(ViewportTools& tools, Document& document) {
  cancelAddMuscle(tools.addMuscle, document);
  if (tools.gizmo.drag && document.commands.inGesture()) document.commands.cancelGesture();
  endGizmo(tools);
  tools.box = {};
  tools.gizmo.hovered = GizmoHandle::kNone;
  tools.hover = {};
}

RouteResult routeInput(ViewportTools& tools, const FrameInput& input, const ViewportContext& context) {
  advance(tools.camera, input.deltaSeconds);
  Frame frame{tools, input, context, viewOf(tools.camera, context.size), {}};
  dropStaleHover(tools.hover, context.document);
  const bool letGo = input.keyPressed(Key::kEscape) || input.button(MouseButton::kRight).pressed;
  if (tools.box.armed && letGo) tools.box.armed = false;
  if (tools.owner == PressOwner::kNone) {
    const std::optional<GizmoTarget> target = gizmoTarget(frame);
    updateHover(frame, target);
    takePress(frame, target);
    if (tools.owner == PressOwner::kNone) takeWantedDrag(frame, target);
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
