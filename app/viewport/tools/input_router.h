// app/viewport/tools/input_router.h: passes input to axis triad, box, handles, tool or camera, in this order.
#pragma once

#include "app/viewport/tools/viewport_tools.h"

namespace sinew::app {

void setTool(ViewportTools& tools, ToolKind tool);  ///< Changes the tool and the gizmo's mode; ignored during drags.

/// setTool, then starts a drag of the whole muscle at the pointer in the next frame, like Blender's G: without a
/// button, a click or Enter keeps it, Esc or the right button cancels it. No drag without Tool::whole, without a
/// target, or with the pointer outside the picture.
void startDrag(ViewportTools& tools, ToolKind tool);

/// The next press on the picture begins a selection box; Esc or the right button cancels it.
void armBox(ViewportTools& tools);

/// Whether a drag uses X, Y, Z, digits, Enter, Esc and Backspace; then menus, keymaps and undo do not.
[[nodiscard]] bool ownsKeyboard(const ViewportTools& tools);

/// Whether the pose is held, even if a clip plays: a muscle is being drawn on the skin, or the press of this frame may
/// begin one and must find the skin as it was shown.
[[nodiscard]] bool holdsPose(const ViewportTools& tools, bool leftPressed);

void keepDrag(ViewportTools& tools, Document& document);  ///< Ends and keeps a drag of startDrag.

void cancelDrags(ViewportTools& tools, Document& document);  ///< Ends and undoes all drags.

/// One frame, after ImGui's input and with the pose of this frame; the surface may be that of the last frame. May
/// change the rig (CommandStack::revision). Picks the skin at most once, when the pointer has moved or presses, never
/// during a drag.
///   left: triad, handle, tool (add muscle: a press on the skin); else a click picks and a drag orbits
///   Ctrl+left, or left after armBox: a selection box; Shift adds, Alt removes
///   Alt+left or middle: orbit; Shift+middle or right: pan; wheel: zoom to the pointer
///   right without motion: RouteResult::menu
RouteResult routeInput(ViewportTools& tools, const ViewportInput& input, const ViewportContext& context);

}  // namespace sinew::app
