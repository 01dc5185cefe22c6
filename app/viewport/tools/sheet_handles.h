// app/viewport/tools/sheet_handles.h: handles on the points of the active sheet's edges.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/viewport/tools/viewport_context.h"
#include "app/viewport/tools/viewport_input.h"

namespace sinew::app {

/// A point of an edge of a sheet.
struct EdgePoint {
  int edge = 0;
  int point = 0;

  friend bool operator==(const EdgePoint&, const EdgePoint&) = default;
};

/// A drag of one point along the skin.
struct EdgePointDrag {
  EdgePoint point;
  std::string sheet;
  glm::vec2 grip{0.0f};  ///< From the handle to the pointer, pixels.
};

struct SheetHandles {
  std::optional<EdgePoint> hovered;
  std::optional<EdgePointDrag> drag;
};

/// World.
struct ShownSheet {
  int index = -1;                             ///< Into Rig::sheets.
  std::vector<std::vector<glm::vec3>> edges;  ///< Points of each, origin first.
};

/// The edges of the active muscle in a pose; nullopt: it is no sheet, is hidden or locked, or this character lacks a
/// bone of its edges.
[[nodiscard]] std::optional<ShownSheet> shownSheet(const Document& document, const Pose& pose);
[[nodiscard]] std::vector<glm::vec3> edgeInPose(const SheetEdge& edge, const Skeleton& skeleton, const Pose& pose);

/// The nearest point within a few pixels.
[[nodiscard]] std::optional<EdgePoint> edgePointUnder(const ViewportContext& context, const View& view,
                                                      const glm::vec2& pixel);

/// Starts a drag of the hovered point.
void beginEdgePoint(SheetHandles& handles, const ViewportContext& context, const View& view, const glm::vec2& pixel);
/// @return false: the drag has ended, by a release (one undo step) or canceled by Esc or the right button
[[nodiscard]] bool continueEdgePoint(SheetHandles& handles, const ViewportInput& input, const ViewportContext& context,
                                     const View& view);

/// For the status line; "" if no point is hovered or dragged.
[[nodiscard]] std::string describe(const SheetHandles& handles, const Document& document);
/// "origin", "insertion", "edge 2"
[[nodiscard]] std::string nameOfEdge(const MuscleSheet& sheet, int edge);

}  // namespace sinew::app
