// app/tools/hover_draw.h: where a muscle would land: the skin and the bone under the pointer light up.
#pragma once

#include "app/tools/select.h"

struct ImDrawList;

namespace sinew::app {

/// A ring on the skin, the bone's segment through everything, its name beside the pointer. Nothing without skin under
/// the pointer. Needs a current ImGui frame, for its font.
/// @param topLeft        where the viewport's pixel (0, 0) lies in the draw list's coordinates.
/// @param unitsPerPixel  draw list units per viewport pixel.
/// @param uiScale        draw list units per design pixel.
void drawLanding(ImDrawList& list, const ViewportHover& hover, const Character& character, const Pose& pose,
                 const View& view, const glm::vec2& topLeft, float unitsPerPixel, float uiScale);

}  // namespace sinew::app
