// app/tools/line_draw.h: muscle lines over the picture: the active one with its handles, and the one being drawn.
#pragma once

#include <imgui.h>

#include "app/render/view.h"
#include "app/tools/line_handles.h"
#include "app/tools/line_tool.h"

namespace sinew::app {

/// Where the picture is in the window.
struct PictureFrame {
  const View& view;
  glm::vec2 topLeft{0.0f};
  float unitsPerPixel = 1.0f;
  float uiScale = 1.0f;
};

void drawLine(ImDrawList& list, const PictureFrame& frame, const ShownLine& line, const LineHandles& handles);
/// The bones at both ends of a line that is being drawn.
void drawLineEnds(ImDrawList& list, const PictureFrame& frame, const LineDrag& drag, const Skeleton& skeleton,
                  const Pose& pose);

}  // namespace sinew::app
