// app/viewport/tools/viewport_tools.h: the viewport's tools, their state between frames, and the result of a frame.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/ui/icons.h"
#include "app/viewport/tools/add_muscle.h"
#include "app/viewport/tools/axis_triad.h"
#include "app/viewport/tools/camera.h"
#include "app/viewport/tools/gizmo.h"
#include "app/viewport/tools/line_handles.h"
#include "app/viewport/tools/line_tool.h"
#include "app/viewport/tools/pick_cycle.h"
#include "app/viewport/tools/select.h"
#include "app/viewport/tools/sheet_handles.h"
#include "app/viewport/tools/sheet_tool.h"
#include "app/viewport/tools/viewport_context.h"
#include "app/viewport/tools/viewport_input.h"
#include "sinew/character/pose.h"

namespace sinew::app {

enum class ToolKind { kSelect, kAddMuscle, kMuscleLine, kSheet, kMove, kRotate, kScale, kPose };  ///< Rows of tools().
inline constexpr std::size_t kToolCount = 8;

[[nodiscard]] std::string nameOf(ToolKind tool);  ///< Its label in lower case: "add muscle".
[[nodiscard]] bool addsMuscles(ToolKind tool);

enum class GizmoPivot { kActive, kCentroid };

[[nodiscard]] const char* nameOf(GizmoPivot pivot);  ///< "active", "centroid"

/// Another muscle dragged along with the active one.
struct GizmoCompanion {
  PrimitiveId primitive;
  Placement start;
};

/// Who holds the mouse from a press to its release.
enum class PressOwner { kNone, kOutside, kGizmo, kLine, kEdge, kTool, kClick, kOrbit, kPan, kBox, kMenu };

/// Rotations of joints with the rings; the rig does not change.
struct PoseBoneState {
  int bone = -1;                             ///< Being rotated; -1: none.
  glm::quat before{1.0f, 0.0f, 0.0f, 0.0f};  ///< Its rotation before the drag, restored by Esc.
  glm::quat start{1.0f, 0.0f, 0.0f, 0.0f};   ///< Its rotation to which that of the drag is added.
  glm::quat shown{1.0f, 0.0f, 0.0f, 0.0f};   ///< Its rotation in the pose of this frame.
};

/// State of the tools between frames.
struct ViewportTools {
  ToolKind tool = ToolKind::kMove;  ///< Set by setTool.
  GizmoState gizmo;                 ///< `axes` may be set between drags.
  AddMuscleState addMuscle;
  LineToolState line;
  LineHandles lineHandles;
  SheetToolState sheet;
  SheetHandles sheetHandles;
  PoseBoneState pose;
  Camera camera;
  ViewportHover hover;
  PickCycle cycle;
  PressOwner owner = PressOwner::kNone;
  MouseButton ownerButton = MouseButton::kLeft;
  glm::vec2 pressPixel{0.0f};
  glm::vec2 lastPixel{0.0f};
  PrimitiveId gizmoPrimitive;              ///< Being dragged.
  std::vector<GizmoCompanion> companions;  ///< Dragged along.
  GizmoPivot pivot = GizmoPivot::kActive;  ///< For several selected muscles; may be set between drags.
  BoxSelectState box;
  bool dragWanted = false;     ///< By startDrag: begins in the next frame.
  bool buttonless = false;     ///< The gizmo's drag needs no button; a click or Enter keeps it.
  bool territoryMode = false;  ///< Clicks on bones edit the active muscle's territory, whatever the tool.
  AxisTriad triad;
};

struct RouteResult {
  View view;                          ///< After the input.
  GizmoLayout gizmo;                  ///< In that view.
  GizmoContext gizmoContext;          ///< For drawGizmo, if visible.
  std::string status;                 ///< The status line.
  std::optional<Error> refusal;       ///< Why an edit was refused.
  std::string said;                   ///< Toast about further changes; or empty.
  std::optional<ViewportHover> menu;  ///< Right-clicked: opens its menu.
  bool needsFrame = false;            ///< Something moves or is being dragged.
};

/// One frame of the input router.
struct ToolFrame {
  ViewportTools& tools;
  const ViewportInput& input;
  const ViewportContext& context;
  View view;
  RouteResult result;

  [[nodiscard]] Document& document() const { return context.document; }
};

/// Target of the handles.
struct GizmoTarget {
  int primitive = -1;  ///< Rig index; -1: a joint.
  Placement placement;
  GizmoContext context;
};

/// A row of the table in viewport_tools.cpp, with the functions that the input router calls; null: not used.
struct Tool {
  const char* id;      ///< Id of its action: "tool/add-muscle".
  const char* label;   ///< "Add muscle"
  const char* hint;    ///< One sentence for tooltip and palette.
  int key;             ///< GLFW's code in the default keymap.
  bool shift = false;  ///< With Shift.
  Icon icon = Icon::kNone;
  GizmoMode handles = GizmoMode::kPoles;   ///< On the target.
  GizmoHandle whole = GizmoHandle::kNone;  ///< Handle to grab when startDrag starts a drag; kNone: none.
  bool onSkin = false;                     ///< Draws on the skin: hovers without motion, and its drags hold the pose.
  bool picksMuscles = false;               ///< Clicks select, repeated ones what lies behind (pick_cycle.h).

  /// Target in this frame. @param atStart  for a drag in progress: at its start, in this frame's pose
  std::optional<GizmoTarget> (*target)(const ToolFrame& frame, bool atStart) = nullptr;
  /// Starts a drag of the hovered handle. @return false: not possible
  bool (*beginHandle)(ToolFrame& frame, const GizmoTarget& target) = nullptr;
  bool (*continueHandle)(ToolFrame& frame, const ViewportInput& input) = nullptr;  ///< @return false: the drag is over

  ViewportHover (*hover)(const ViewportContext& context, const View& view, const glm::vec2& pixel);
  bool (*press)(ToolFrame& frame) = nullptr;  ///< A press outside the handles. @return whether the tool takes the mouse
  bool (*drag)(ToolFrame& frame, const ViewportInput& input) = nullptr;  ///< While it has it. @return false: it is over
  void (*cancel)(ViewportTools& tools, Document& document) = nullptr;    ///< Ends and undoes a drag.
  void (*click)(ToolFrame& frame) = nullptr;                             ///< A click outside the handles.
  std::string (*describe)(const ToolFrame& frame);  ///< The status line, unless a handle is hovered or dragged.
};

[[nodiscard]] std::span<const Tool* const, kToolCount> tools();    ///< By ToolKind.
[[nodiscard]] const Tool& activeTool(const ViewportTools& tools);  ///< The chosen tool, or the territory mode if on.

extern const Tool kSelectTool;
extern const Tool kMoveTool;
extern const Tool kRotateTool;
extern const Tool kScaleTool;
extern const Tool kAddMuscleTool;
extern const Tool kPoseTool;
extern const Tool kMuscleLineTool;
extern const Tool kSheetTool;
extern const Tool kTerritoryTool;  ///< A mode over the chosen tool, not in tools().

// Several selected muscles on one gizmo; in gizmo_tools.cpp.

/// The other selected muscles that a drag of `active` (a rig index) moves: attached, neither hidden nor locked, in the
/// order of selection. Only the active or first selected one of linked twins, since the other follows.
[[nodiscard]] std::vector<GizmoCompanion> companionsOf(const Document& document, int active);

/// Mean of the centers of the active muscle and its companions in a pose; nullopt without companions.
[[nodiscard]] std::optional<glm::vec3> centroidOf(const Document& document, const Pose& pose, int activeIndex,
                                                  const Placement& active,
                                                  const std::vector<GizmoCompanion>& companions);

/// The rig after a drag of the active muscle and its companions. Error: a placement is refused.
[[nodiscard]] Result<Rig> dragged(const Document& document, const Pose& pose, int active, const DragResult& drag,
                                  const std::vector<GizmoCompanion>& companions);

// Territory mode: clicks on bones choose the skin that the active muscle may move; in territory_tool.cpp.

/// Rig index of the active muscle if this character has its bone, else -1. Sheets get their territories from the skin.
[[nodiscard]] int territorySubject(const Document& document);

/// Adds or removes a bone, naming all of the territory; bones that the character lacks stay. Error: it is the last.
[[nodiscard]] Result<Rig> withTerritoryBone(const Rig& rig, int index, int bone, const Skeleton& skeleton);

/// The same for the active muscle, as one undo step. Error: nothing has changed.
Result<void> toggleTerritoryBone(Document& document, int bone);

}  // namespace sinew::app
