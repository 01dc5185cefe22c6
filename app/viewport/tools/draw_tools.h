// app/viewport/tools/draw_tools.h: what tools draw over the picture through ImGui's draw list.
#pragma once

#include <string>
#include <vector>

#include <imgui.h>

#include "app/viewport/tools/gizmo.h"
#include "app/viewport/tools/line_handles.h"
#include "app/viewport/tools/select.h"
#include "app/viewport/tools/sheet_handles.h"

namespace sinew::app {

/// Maps the picture to a draw list.
struct Canvas {
  const View& view;
  glm::vec2 topLeft;    ///< The viewport's pixel (0, 0), draw list units.
  float unitsPerPixel;  ///< Draw list units per viewport pixel.
  float scale;          ///< Draw list units per design pixel.

  [[nodiscard]] bool isBehind(const glm::vec3& point) const { return view.toPixel(point).z > 1.0f; }
  [[nodiscard]] ImVec2 at(const glm::vec3& point) const {
    const glm::vec2 p = topLeft + glm::vec2(view.toPixel(point)) * unitsPerPixel;
    return {p.x, p.y};
  }
};

// Text needs a current ImGui frame for its font.

/// A name under the box of a mesh.
void drawMeshName(ImDrawList& list, const Canvas& canvas, const Bounds& box, const std::string& name);

/// A bone's segment over everything, unless an end is behind the eye.
void drawBoneMark(ImDrawList& list, const Canvas& canvas, const Bone& bone, const glm::mat4& boneInWorld);

/// Marks where a muscle would be added, if there is skin under the pointer: a ring on it, the bone and its name.
void drawLanding(ImDrawList& list, const Canvas& canvas, const ViewportHover& hover, const Character& character,
                 const Pose& pose);

/// The handles of the active muscle's line. @param curve  the line too, if LineDrawer::drawMuscleLines does not draw it
void drawLine(ImDrawList& list, const Canvas& canvas, const ShownLine& line, const LineHandles& handles, bool curve);

/// Edges of a sheet with the handles on their points; the origin's are round, those of the insertion diamonds.
void drawSheetEdges(ImDrawList& list, const Canvas& canvas, const ShownSheet& sheet, const SheetHandles& handles);
/// An edge that is being drawn.
void drawStroke(ImDrawList& list, const Canvas& canvas, const std::vector<glm::vec3>& points);

/// Handles, hover and the marks of a drag (axis line, wedge, number), clipped to the viewport. Layout and context are
/// those of this frame (RouteResult). @param topLeft, unitsPerPixel  as in Canvas
void drawGizmo(ImDrawList& list, const GizmoState& state, const GizmoLayout& layout, const GizmoContext& context,
               const glm::vec2& topLeft, float unitsPerPixel);

}  // namespace sinew::app
