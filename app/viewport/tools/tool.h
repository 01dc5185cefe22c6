// app/viewport/tools/tool.h: what a tool of the viewport is: names, and the functions that the input router calls.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "app/ui/icons.h"
#include "app/viewport/tools/gizmo.h"
#include "app/viewport/tools/input.h"
#include "app/viewport/tools/viewport_context.h"
#include "app/viewport/tools/viewport_tools.h"

namespace sinew::app {

/// One frame's work of the router, so that its stages need no long parameter lists.
struct ToolFrame {
  ViewportTools& tools;
  const ViewportInput& input;
  const ViewportContext& context;
  View view;
  RouteResult result;

  [[nodiscard]] Document& document() const { return context.document; }
};

/// What the handles stand on.
struct GizmoTarget {
  int primitive = -1;  ///< Rig index; -1: a joint.
  Placement placement;
  GizmoContext context;
};

/// A tool: a row of the table in tool_table.cpp. Null functions: the tool does nothing of the kind.
struct Tool {
  const char* id;     ///< Its action: "tool/add-muscle".
  const char* label;  ///< "Add muscle"
  const char* hint;   ///< One sentence for tooltip and palette.
  int key;            ///< GLFW's code, in the default keymap.
  bool shift;         ///< With Shift.
  Icon icon;
  GizmoMode handles;  ///< Which handles stand on the target.
  GizmoHandle whole;  ///< The handle that a drag without a press takes (startDrag); kNone: there is none.
  bool onSkin;  ///< Draws on the skin: looks under a pointer at rest too, and the pose stands still for its drags.

  bool picksMuscles;  ///< Clicks select; further ones on the same place what lies behind (pick_cycle.h).

  /// What the handles stand on in this frame. @param atStart  for a drag in progress: where they stood when it began,
  /// in this frame's pose.
  std::optional<GizmoTarget> (*target)(const ToolFrame& frame, bool atStart);
  /// Starts a drag of the hovered handle. @return false: it cannot.
  bool (*beginHandle)(ToolFrame& frame, const GizmoTarget& target);
  /// @return false: the drag has ended.
  bool (*continueHandle)(ToolFrame& frame, const ViewportInput& input);

  ViewportHover (*hover)(const ViewportContext& context, const View& view, const glm::vec2& pixel);
  /// A press beside the handles. @return whether the tool holds the mouse from now on.
  bool (*press)(ToolFrame& frame);
  /// While it does. @return false: it has ended.
  bool (*drag)(ToolFrame& frame, const ViewportInput& input);
  /// Ends what `drag` does, without a trace.
  void (*cancel)(ViewportTools& tools, Document& document);
  /// A release where the press was, beside the handles. Null: nothing is picked.
  void (*click)(ToolFrame& frame);
  /// The status line while nothing is dragged and no handle is hovered.
  std::string (*describe)(const ToolFrame& frame);
};

/// By ToolKind.
[[nodiscard]] std::span<const Tool* const, kToolCount> tools();
/// The tool that has the clicks: the chosen one, or the territory mode while it is on.
[[nodiscard]] const Tool& activeTool(const ViewportTools& tools);

// The rows, each in a file of its own.
extern const Tool kSelectTool;
extern const Tool kMoveTool;
extern const Tool kRotateTool;
extern const Tool kScaleTool;
extern const Tool kAddMuscleTool;
extern const Tool kPoseTool;
extern const Tool kMuscleLineTool;
extern const Tool kTerritoryTool;  ///< A mode over the chosen tool, not in tools().

}  // namespace sinew::app
