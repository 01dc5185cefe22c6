// app/viewport/tools/viewport_tools.h: all that the tools of the viewport remember between frames, and what a frame
// gives.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/tools/add_muscle.h"
#include "app/viewport/tools/axis_triad.h"
#include "app/viewport/tools/box_select.h"
#include "app/viewport/tools/camera.h"
#include "app/viewport/tools/gizmo.h"
#include "app/viewport/tools/gizmo_group.h"
#include "app/viewport/tools/line_handles.h"
#include "app/viewport/tools/line_tool.h"
#include "app/viewport/tools/pick_cycle.h"
#include "app/viewport/tools/pose_bone.h"
#include "app/viewport/tools/select.h"

namespace sinew::app {

/// Rows of the table of tools (tool.h).
enum class ToolKind { kSelect, kAddMuscle, kMuscleLine, kMove, kRotate, kScale, kPose };
inline constexpr std::size_t kToolCount = 7;

[[nodiscard]] std::string nameOf(ToolKind tool);  ///< Its label in lower case: "add muscle".

/// Who holds the mouse from a press to its release.
enum class PressOwner { kNone, kOutside, kGizmo, kLine, kTool, kClick, kOrbit, kPan, kBox, kMenu };

/// All that the viewport's tools remember between frames.
struct ViewportTools {
  ToolKind tool = ToolKind::kMove;  ///< Through setTool.
  GizmoState gizmo;                 ///< `axes` is free to set between drags.
  AddMuscleState addMuscle;
  LineToolState line;
  LineHandles lineHandles;
  PoseBoneState pose;
  Camera camera;
  ViewportHover hover;
  PickCycle cycle;
  PressOwner owner = PressOwner::kNone;
  MouseButton ownerButton = MouseButton::kLeft;
  glm::vec2 pressPixel{0.0f};
  glm::vec2 lastPixel{0.0f};
  PrimitiveId gizmoPrimitive;              ///< The one being dragged.
  std::vector<GizmoCompanion> companions;  ///< Dragged along with it.
  GizmoPivot pivot = GizmoPivot::kActive;  ///< Where several selected muscles turn. Free to set between drags.
  BoxSelectState box;
  bool dragWanted = false;     ///< Through startDrag: begins with the next frame.
  bool buttonless = false;     ///< The gizmo's drag goes on without a button: a click or Enter keeps it.
  bool territoryMode = false;  ///< Clicks on bones change the active muscle's territory, whatever the tool.
  AxisTriad triad;
};

struct RouteResult {
  View view;                          ///< After the input: what to draw with.
  GizmoLayout gizmo;                  ///< In that view: for drawGizmo and --log-state. Not visible: nothing to draw.
  GizmoContext gizmoContext;          ///< For drawGizmo, if visible.
  std::string status;                 ///< What the tool does next: the status line.
  std::optional<Error> refusal;       ///< Why an edit was refused.
  std::string said;                   ///< What a tool did beyond what was drawn: a toast. Empty: nothing.
  std::optional<ViewportHover> menu;  ///< The right button was clicked on this: its menu is asked for.
  bool needsFrame = false;            ///< Something moves or is being dragged: draw again soon.
};

}  // namespace sinew::app
