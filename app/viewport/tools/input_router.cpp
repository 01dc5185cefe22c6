// app/viewport/tools/input_router.cpp: passes input to the owner of the mouse.

#include "app/viewport/tools/input_router.h"

#include <utility>

#include <glm/geometric.hpp>

#include "app/viewport/tools/status_line.h"
#include "app/viewport/tools/viewport_tools.h"

namespace sinew::app {
namespace {

// The handles -----------------------------------------------------------------------------------------------------

std::optional<GizmoTarget> gizmoTarget(const ToolFrame& frame) {
  const Tool& tool = activeTool(frame.tools);
  return tool.target ? tool.target(frame, false) : std::nullopt;
}

void beginGizmo(ToolFrame& frame, const GizmoTarget& target) {
  if (activeTool(frame.tools).beginHandle(frame, target)) frame.tools.owner = PressOwner::kGizmo;
}

void endGizmo(ViewportTools& tools) {
  tools.gizmo.drag.reset();
  tools.gizmoPrimitive = {};
  tools.companions.clear();
  tools.buttonless = false;
  tools.pose.bone = -1;
  tools.owner = PressOwner::kNone;
}

// Hover -----------------------------------------------------------------------------------------------------------

/// The rig or the character may have changed.
void dropStaleHover(ViewportHover& hover, const Document& document) {
  if (hover.primitive >= static_cast<int>(document.rig().primitives.size())) hover.primitive = -1;
  if (hover.bone >= static_cast<int>(document.character->skeleton.bones.size())) hover.bone = -1;
  if (hover.skin && hover.skin->triangle >= static_cast<int>(document.character->mesh.triangles.size())) hover = {};
}

bool pointerInside(const ToolFrame& frame) {
  const glm::vec2 mouse = frame.input.mouse;
  return mouse.x >= 0.0f && mouse.y >= 0.0f && mouse.x < static_cast<float>(frame.context.size.x) &&
         mouse.y < static_cast<float>(frame.context.size.y);
}

bool anyPressed(const ViewportInput& input) {
  return input.buttons[0].pressed || input.buttons[1].pressed || input.buttons[2].pressed;
}

/// With Shift or Ctrl the first entry, whatever was clicked before.
void lookUnderPointer(ToolFrame& frame) {
  ViewportTools& tools = frame.tools;
  const Tool& tool = activeTool(tools);
  tools.hover = tool.hover(frame.context, frame.view, frame.input.mouse);
  if (!tool.picksMuscles || frame.input.shift || frame.input.ctrl) return;
  aim(tools.hover, tools.cycle, frame.context, frame.view, frame.input.mouse);
}

void updateHover(ToolFrame& frame, const std::optional<GizmoTarget>& target) {
  ViewportTools& tools = frame.tools;
  tools.gizmo.hovered = GizmoHandle::kNone;
  tools.lineHandles.hovered = LineEnd::kNone;
  tools.sheetHandles.hovered.reset();
  if (frame.input.mouseTaken || !pointerInside(frame)) {
    tools.hover = {};
    return;
  }
  if (activeTool(tools).picksMuscles && !frame.input.alt) {
    tools.lineHandles.hovered = lineEndUnder(frame.context, frame.view, frame.input.mouse);
    tools.sheetHandles.hovered = edgePointUnder(frame.context, frame.view, frame.input.mouse);
  }
  if (tools.lineHandles.hovered == LineEnd::kNone && target && !frame.input.alt) {
    tools.gizmo.hovered = hitTest(layoutGizmo(tools.gizmo, target->placement, target->context), frame.input.mouse);
  }
  if (tools.lineHandles.hovered != LineEnd::kNone || tools.sheetHandles.hovered ||
      tools.gizmo.hovered != GizmoHandle::kNone) {
    tools.hover = {};
    return;
  }
  const bool news = frame.input.mouse != tools.lastPixel || anyPressed(frame.input) || frame.input.wheel != 0.0f ||
                    activeTool(tools).onSkin;
  if (news) lookUnderPointer(frame);
}

// Presses ---------------------------------------------------------------------------------------------------------

void take(ViewportTools& tools, PressOwner owner, MouseButton button, const glm::vec2& pixel) {
  tools.owner = owner;
  tools.ownerButton = button;
  tools.pressPixel = pixel;
}

void pressLeft(ToolFrame& frame, const std::optional<GizmoTarget>& target) {
  ViewportTools& tools = frame.tools;
  take(tools, PressOwner::kClick, MouseButton::kLeft, frame.input.mouse);
  const bool overHandle = target && tools.gizmo.hovered != GizmoHandle::kNone;
  if (tools.box.armed || (frame.input.ctrl && !overHandle && !tools.territoryMode)) {
    tools.box = {false, BoxDrag{frame.input.mouse, frame.input.mouse, BoxMode::kReplace}};
    tools.owner = PressOwner::kBox;
  } else if (frame.input.alt) {
    tools.owner = PressOwner::kOrbit;
  } else if (tools.lineHandles.hovered != LineEnd::kNone) {
    beginLineEnd(tools.lineHandles, frame.context, frame.view, frame.input.mouse);
    tools.owner = PressOwner::kLine;
  } else if (tools.sheetHandles.hovered) {
    beginEdgePoint(tools.sheetHandles, frame.context, frame.view, frame.input.mouse);
    tools.owner = PressOwner::kEdge;
  } else if (overHandle) {
    beginGizmo(frame, *target);
  } else if (const Tool& tool = activeTool(tools); tool.press && tool.press(frame)) {
    tools.owner = PressOwner::kTool;
  }
}

void takePress(ToolFrame& frame, const std::optional<GizmoTarget>& target) {
  ViewportTools& tools = frame.tools;
  for (const MouseButton button : {MouseButton::kLeft, MouseButton::kMiddle, MouseButton::kRight}) {
    if (!frame.input.button(button).pressed) continue;
    const glm::vec2 mouse = frame.input.mouse;
    if (frame.input.mouseTaken || !pointerInside(frame)) take(tools, PressOwner::kOutside, button, mouse);
    else if (button == MouseButton::kLeft) pressLeft(frame, target);
    else if (button == MouseButton::kRight) take(tools, PressOwner::kMenu, button, mouse);
    else if (frame.input.shift) take(tools, PressOwner::kPan, button, mouse);
    else take(tools, PressOwner::kOrbit, button, mouse);
    return;
  }
}

void takeWantedDrag(ToolFrame& frame, const std::optional<GizmoTarget>& target) {
  ViewportTools& tools = frame.tools;
  const bool wanted = std::exchange(tools.dragWanted, false);
  const GizmoHandle handle = activeTool(tools).whole;
  if (!wanted || !target || handle == GizmoHandle::kNone || !pointerInside(frame)) return;
  tools.gizmo.hovered = handle;
  take(tools, PressOwner::kGizmo, MouseButton::kLeft, frame.input.mouse);
  beginGizmo(frame, *target);
  tools.buttonless = tools.owner == PressOwner::kGizmo;
}

// The owner of the press ----------------------------------------------------------------------------------------

bool isDragged(const ToolFrame& frame) {
  return glm::length(frame.input.mouse - frame.tools.pressPixel) > kDragThreshold * frame.context.uiScale;
}

void continueClick(ToolFrame& frame, bool released) {
  ViewportTools& tools = frame.tools;
  if (isDragged(frame)) {
    orbit(tools.camera, frame.input.mouse - tools.pressPixel, frame.context.size);
    tools.owner = PressOwner::kOrbit;
  } else if (const Tool& tool = activeTool(tools); released && tool.click) {
    tool.click(frame);
  }
}

/// A right click opens a menu, a right drag pans.
void continueMenu(ToolFrame& frame, bool released) {
  ViewportTools& tools = frame.tools;
  if (isDragged(frame)) {
    pan(tools.camera, frame.input.mouse - tools.pressPixel, frame.context.size);
    tools.owner = PressOwner::kPan;
  } else if (released) {
    ViewportHover here = hoverAt(frame.context, frame.view, tools.pressPixel);
    aimAtSelected(here, frame.document());
    frame.result.menu = std::move(here);
  }
}

/// A click on a handle continues a cycle of picks there.
void clickThroughHandle(ToolFrame& frame) {
  ViewportTools& tools = frame.tools;
  const Tool& tool = activeTool(tools);
  if (isDragged(frame) || !tool.picksMuscles || frame.input.shift || frame.input.ctrl) return;
  if (!goesOn(tools.cycle, frame.context, frame.view, frame.input.mouse)) return;
  tools.gizmo.hovered = GizmoHandle::kNone;
  lookUnderPointer(frame);
  if (tools.hover.taken >= 0) tool.click(frame);
}

/// Resizes the box. One as small as a click adds as a click does.
void continueBox(ToolFrame& frame, const ViewportInput& input, bool released) {
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
  const bool click = glm::length(box.to - box.from) <= kDragThreshold * frame.context.uiScale;
  if (click) pick(frame.document(), tools.hover, true);
  else selectBox(frame.context, frame.view, box);
  tools.box.drag.reset();
}

void continueOwner(ToolFrame& frame) {
  ViewportTools& tools = frame.tools;
  // A release may have been lost with the focus.
  ViewportInput input = frame.input;
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
      if (!activeTool(tools).continueHandle(frame, input)) {
        const bool byButton = released && !tools.buttonless;
        endGizmo(tools);
        if (byButton) clickThroughHandle(frame);
      }
      break;
    case PressOwner::kLine:
      if (!continueLineEnd(tools.lineHandles, input, frame.context, frame.view)) tools.owner = PressOwner::kNone;
      break;
    case PressOwner::kEdge:
      if (!continueEdgePoint(tools.sheetHandles, input, frame.context, frame.view)) {
        tools.owner = PressOwner::kNone;
        if (released) clickThroughHandle(frame);
      }
      break;
    case PressOwner::kTool:
      if (!activeTool(tools).drag(frame, input)) tools.owner = PressOwner::kNone;
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
    case PressOwner::kMenu:
      continueMenu(frame, released);
      break;
  }
  if (released) tools.owner = PressOwner::kNone;
}

void wheel(ToolFrame& frame) {
  ViewportTools& tools = frame.tools;
  const bool free = tools.owner == PressOwner::kNone && !frame.input.mouseTaken && pointerInside(frame);
  if (!free || frame.input.wheel == 0.0f) return;
  const std::optional<glm::vec3> point = tools.hover.any() ? std::optional(tools.hover.pointInWorld) : std::nullopt;
  zoomToward(tools.camera, frame.input.wheel, frame.input.mouse, frame.context.size, point);
}

/// Explains why a driven muscle does not follow the pointer.
std::string drawnOtherwise(const ToolFrame& frame) {
  const Document& document = frame.document();
  const int active = document.activePrimitive();
  if (frame.tools.tool == ToolKind::kPose || active < 0) return "";
  const auto index = static_cast<std::size_t>(active);
  if (document.rig().primitives[index].animated.empty()) return "";
  const RigNumbers& now = document.posedRig(frame.context.pose).numbers;
  if (now.primitives[index].placement == document.rig().primitives[index].placement) return "";
  return " \xc2\xb7 Keys or drivers change this muscle here; handles edit its placement in the rig";
}

std::string statusOf(const ToolFrame& frame) {
  const ViewportTools& tools = frame.tools;
  if (std::string onTriad = describe(tools.triad); !onTriad.empty()) return onTriad;
  if (tools.gizmo.drag || tools.gizmo.hovered != GizmoHandle::kNone) {
    return describe(tools.gizmo) + drawnOtherwise(frame);
  }
  if (const std::string onLine = describe(tools.lineHandles); !onLine.empty()) return onLine;
  if (std::string onSheet = describe(tools.sheetHandles, frame.document()); !onSheet.empty()) return onSheet;
  if (tools.box.drag) {
    return statusLine("Box", {"Release selects what it touches", "Shift adds", "Alt removes", "Esc cancels"});
  }
  if (tools.box.armed) {
    return statusLine("Box", {"Drag selects what it touches", "Shift adds", "Alt removes", "Esc ends"});
  }
  if (tools.owner == PressOwner::kOrbit) return statusLine("Orbit", {"Release ends"});
  if (tools.owner == PressOwner::kPan) return statusLine("Pan", {"Release ends"});
  return activeTool(tools).describe(frame);
}

}  // namespace

void setTool(ViewportTools& tools, ToolKind tool) {
  if (ownsKeyboard(tools)) return;
  if (tool != tools.tool) tools.sheet = {};
  tools.tool = tool;
  tools.gizmo.mode = sinew::app::tools()[static_cast<std::size_t>(tool)]->handles;
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
  return tools.gizmo.drag || tools.owner == PressOwner::kTool || tools.owner == PressOwner::kLine ||
         tools.owner == PressOwner::kEdge || tools.box.drag || tools.box.armed;
}

bool holdsPose(const ViewportTools& tools, bool leftPressed) {
  return activeTool(tools).onSkin && (tools.owner == PressOwner::kTool || leftPressed);
}

void keepDrag(ViewportTools& tools, Document& document) {
  if (!tools.buttonless) return;
  document.commands.endGesture();
  endGizmo(tools);
}

void cancelDrags(ViewportTools& tools, Document& document) {
  if (const Tool& tool = activeTool(tools); tool.cancel) tool.cancel(tools, document);
  const bool edits = tools.gizmo.drag || tools.lineHandles.drag || tools.sheetHandles.drag;
  if (edits && document.commands.inGesture()) document.commands.cancelGesture();
  tools.lineHandles = {};
  tools.sheetHandles = {};
  tools.sheet = {};
  endGizmo(tools);
  tools.box = {};
  tools.dragWanted = false;
  tools.gizmo.hovered = GizmoHandle::kNone;
  tools.hover = {};
}

RouteResult routeInput(ViewportTools& tools, const ViewportInput& all, const ViewportContext& context) {
  if (territorySubject(context.document) < 0) tools.territoryMode = false;
  const bool busy = tools.owner != PressOwner::kNone;
  const ViewportInput input = passTriad(tools.triad, tools.camera, all, context.size, context.uiScale, busy);
  advance(tools.camera, input.deltaSeconds);
  ToolFrame frame{tools, input, context, viewOf(tools.camera, context.size), {}};
  dropStaleHover(tools.hover, context.document);
  const bool letGo = input.keyPressed(Key::kEscape) || input.button(MouseButton::kRight).pressed;
  const bool boxLetGo = tools.box.armed && letGo;
  if (boxLetGo) tools.box.armed = false;
  if (tools.owner == PressOwner::kNone) {
    const std::optional<GizmoTarget> target = gizmoTarget(frame);
    updateHover(frame, target);
    takePress(frame, target);
    if (boxLetGo && tools.owner == PressOwner::kMenu) tools.owner = PressOwner::kOutside;
    if (tools.owner == PressOwner::kNone) takeWantedDrag(frame, target);
    wheel(frame);
    // The first motion after a press belongs to the next frame, unless it is already over.
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
  frame.result.needsFrame = isMoving(tools.camera) || ownsKeyboard(tools) || frame.result.menu.has_value();
  return std::move(frame.result);
}

}  // namespace sinew::app
