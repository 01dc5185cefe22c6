// app/viewport/tools/sheet_stroke.h: sheets from strokes on the skin.
#pragma once

#include <span>

#include "app/viewport/tools/select.h"
#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// A point of an edge: on the strongest bone of the skin there, at the skin without muscles. Error: the bone is
/// flattened in the bind pose.
[[nodiscard]] Result<LineAnchor> edgePointAt(const Character& character, const SkinAnchor& place);

/// An edge along a stroke, with no more points than its bends need. A stroke below 3 % of H is a single point.
/// @param stroke  not empty (asserted)
[[nodiscard]] Result<SheetEdge> edgeAlong(const Character& character, std::span<const SkinAnchor> stroke);

[[nodiscard]] LineSettings linesOfSheets();  ///< Of the lines of new sheets: softer than those of single muscles.

/// A sheet from one edge to another. The insertion is reversed if its strips would cross; two single points get an
/// origin across the way between them. Strips, bellies and heights follow from its size, and it is on lines if its ends
/// are on different bones. Error: the edges are at the same place.
/// @param thicker  factor on the heights
[[nodiscard]] Result<MuscleSheet> sheetBetween(const Character& character, SheetEdge origin, SheetEdge insertion,
                                               float thicker = 1.0f);

/// Adds a sheet in the first group, with a twin unless the plan is null or the sheet crosses its plane.
[[nodiscard]] Result<Rig> withDrawnSheet(const Rig& rig, MuscleSheet sheet, const MirrorPlan* plan);

}  // namespace sinew::app
