// core/surface/diagonals.h: edges inside control triangles that follow rims and valleys. docs/design.md, Detail.
#pragma once

#include <vector>

#include "core/surface/patches/triangulation.h"
#include "core/surface/preparation.h"
#include "sinew/character/pose.h"

namespace sinew {

/// [T] Of two small triangles of one control triangle, the common side becomes the other diagonal of their four points
/// if the normal interpolated along that comes closer, where the two cross, to the surface's own normals in the poses
/// (data-dependent triangulation: Dyn, Levin, Rippa 1990).
/// @param next  as for findLevels().  @param tolerance  of positions, world units
/// @param known [T] the former ones of triangles whose surface has not changed; of the others, {}
[[nodiscard]] std::vector<Triangulation> alignedDiagonals(const Preparation& next, const std::vector<Pose>& poses,
                                                          float tolerance, const RefinementLevels& levels,
                                                          std::vector<Triangulation> known);

}  // namespace sinew
