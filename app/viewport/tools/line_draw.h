// app/viewport/tools/line_draw.h: the active muscle's line over the picture, with its handles.
#pragma once

#include "app/viewport/tools/hover_draw.h"
#include "app/viewport/tools/line_handles.h"

namespace sinew::app {

/// @param curve  draws the line itself as well: where the picture does not (LineDrawer::drawMuscleLines).
void drawLine(ImDrawList& list, const Canvas& canvas, const ShownLine& line, const LineHandles& handles, bool curve);

}  // namespace sinew::app
