// app/viewport/tools/input_router.h: who gets the mouse: axis triad, box, handles, tool, camera, in this order.
#pragma once

#include "app/viewport/tools/viewport_tools.h"

namespace sinew::app {

/// Changes the tool; ignored while a gizmo or muscle drag is in progress. Sets the gizmo's mode.
void setTool(ViewportTools& tools, ToolKind tool);

/// The same, and the next frame begins a drag of the whole muscle at the pointer, as Blender's G does: it goes
/// on without a button until a click or Enter keeps it, Esc or the right button cancels it. Only for tools
/// with such a handle (Tool::whole); without a target, or with the pointer beside the picture, no drag.
void startDrag(ViewportTools& tools, ToolKind tool);

/// The next press on the picture draws a box that selects; Esc or the right button cancels it.
void armBox(ViewportTools& tools);

/// While true, X, Y, Z, digits, Enter, Esc and Backspace belong to a drag: menus and keymaps leave them alone, undo
/// too.
[[nodiscard]] bool ownsKeyboard(const ViewportTools& tools);

/// While true the pose stands still, whatever plays: a muscle is being drawn on the skin, or the press that comes with
/// this frame may begin one and has to find the skin where it was seen.
[[nodiscard]] bool holdsPose(const ViewportTools& tools, bool leftPressed);

/// Ends a drag that goes on without a button (startDrag) as a click on the picture would: what it did is kept.
void keepDrag(ViewportTools& tools, Document& document);

/// Ends a drag without a trace in the rig (the document is about to be replaced).
void cancelDrags(ViewportTools& tools, Document& document);

/// One frame. Called when ImGui has had its input and the pose of this frame is known; the surface may still be the one
/// drawn before. The rig may differ afterwards (watch CommandStack::revision). The skin is picked at most once a frame,
/// only when the pointer has moved or presses, never during a drag.
///   left: triad, else a handle, else the tool (add muscle: a press on the skin), else a click picks and a drag orbits
///   Ctrl+left, or left once after armBox: a box selects; with Shift it adds, with Alt it takes away
///   Alt+left or middle: orbit; Shift+middle or right: pan; wheel: zoom to the pointer
///   right without motion: RouteResult::menu
RouteResult routeInput(ViewportTools& tools, const ViewportInput& input, const ViewportContext& context);

}  // namespace sinew::app
