// app/viewport/tools/gizmo_draw.h: the gizmo through ImGui's draw list.
#pragma once

#include "app/viewport/tools/gizmo.h"

struct ImDrawList;

namespace sinew::app {

/// Draws handles, hover and what a drag shows (axis line, wedge, number), clipped to the viewport. Layout and context
/// are those of this frame (RouteResult). Nothing if the layout is not visible. Needs a current ImGui frame, for its
/// font.
/// @param topLeft     where the viewport's pixel (0, 0) lies in the draw list's coordinates.
/// @param unitsPerPixel  draw list units per viewport pixel (1 unless the window is scaled by the system).
void drawGizmo(ImDrawList& list, const GizmoState& state, const GizmoLayout& layout, const GizmoContext& context,
               const glm::vec2& topLeft, float unitsPerPixel);

}  // namespace sinew::app
