// app/tools/input_router.h: who gets the mouse: ImGui, gizmo, tool, camera, in this order.
#pragma once

#include <string>

#include "app/tools/add_muscle.h"
#include "app/tools/box_select.h"
#include "app/tools/camera.h"
#include "app/tools/gizmo.h"
#include "app/tools/gizmo_group.h"
#include "app/tools/pose_bone.h"
#include "app/tools/select.h"

namespace sinew::app {

/// Select shows the pole handles alone; pose turns joints.
enum class ToolKind { kSelect, kMove, kRotate, kScale, kAddMuscle, kPose };

[[nodiscard]] const char* nameOf(ToolKind tool);  ///< "select", "move", "rotate", "scale", "add muscle", "pose"

/// Who holds the mouse from a press to its release.
enum class PressOwner { kNone, kOutside, kGizmo, kTool, kClick, kOrbit, kPan, kBox };

/// All that the viewport's tools remember between frames.
struct ViewportTools {
  ToolKind tool = ToolKind::kMove;  ///< Through setTool.
  GizmoState gizmo;                 ///< `axes` is free to set between drags.
  AddMuscleState addMuscle;
  PoseBoneState pose;
  Camera camera;
  ViewportHover hover;
  PressOwner owner = PressOwner::kNone;
  MouseButton ownerButton = MouseButton::kLeft;
  glm::vec2 pressPixel{0.0f};
  glm::vec2 lastPixel{0.0f};
  std::string gizmoPrimitive;              ///< Name of the primitive being dragged.
  std::vector<GizmoCompanion> companions;  ///< Dragged along with it.
  GizmoPivot pivot = GizmoPivot::kActive;  ///< Of several selected muscles. Free to set between drags.
  BoxSelectState box;
  bool dragWanted = false;  ///< Through startDrag: begins with the next frame.
  bool buttonless = false;  ///< The gizmo's drag goes on without a button: a click or Enter keeps it.
  bool pickBones = false;   ///< Clicks name bones (RouteResult::pickedBone) and select nothing; no gizmo.
};

/// Changes the tool; ignored while a gizmo or muscle drag is in progress. Sets the gizmo's mode.
void setTool(ViewportTools& tools, ToolKind tool);

/// The same, and the next frame begins a drag of the whole muscle at the pointer, as Blender's G does: it goes
/// on without a button until a click or Enter keeps it, Esc or the right button takes it back. Only for the tools move,
/// rotate and scale; without a gizmo, or with the pointer beside the picture, no drag.
void startDrag(ViewportTools& tools, ToolKind tool);

/// The next press on the picture draws a box that selects; Esc or the right button lets go of it.
void armBox(ViewportTools& tools);

/// While true, X, Y, Z, digits, Enter, Esc and Backspace belong to a drag: menus and keymaps leave them alone, undo
/// too.
[[nodiscard]] bool ownsKeyboard(const ViewportTools& tools);

/// While true the pose stands still, whatever plays: a muscle is being drawn on the skin, or the press that comes with
/// this frame may begin one and has to find the skin where it was seen.
[[nodiscard]] inline bool holdsPose(const ViewportTools& tools, bool leftPressed) {
  return tools.addMuscle.drag || (tools.tool == ToolKind::kAddMuscle && leftPressed);
}

/// Ends a drag without a trace (the document is about to be replaced).
void cancelDrags(ViewportTools& tools, Document& document);

struct RouteResult {
  View view;                  ///< After the input: what to draw with.
  GizmoLayout gizmo;          ///< In that view: for drawGizmo and --log-state. Not visible: nothing to draw.
  GizmoContext gizmoContext;  ///< For drawGizmo, if visible.
  std::string status;         ///< What the tool does next: the status line.
  std::string message;        ///< Why an edit was refused, for the messages panel; else "".
  int pickedBone = -1;        ///< Clicked in this frame with ViewportTools::pickBones; -1: none.
  bool needsFrame = false;    ///< Something moves or is being dragged: draw again soon.
};

/// One frame. Called when ImGui has had its input and the pose of this frame is known; the surface may still be the one
/// drawn before. The rig may differ afterwards (watch CommandStack::revision). The skin is picked at most once a frame,
/// only when the pointer has moved or presses, never during a drag.
///   left: gizmo, else the tool (add muscle: a press on the skin), else a click picks and a drag orbits
///   Ctrl+left, or left once after armBox: a box selects; with Shift it adds, with Alt it takes away
///   Alt+left or middle: orbit; Shift+middle or right: pan; wheel: zoom to the pointer
RouteResult routeInput(ViewportTools& tools, const FrameInput& input, const ViewportContext& context);

}  // namespace sinew::app
