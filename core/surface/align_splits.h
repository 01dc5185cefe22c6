// core/surface/align_splits.h: vertices and edges inside control triangles follow rims and valleys.
// docs/design.md, Detail.
#pragma once

#include <vector>

#include "core/surface/patches/triangulation.h"
#include "core/surface/preparation.h"
#include "sinew/character/pose.h"

namespace sinew {

/// Moves the points of splits along their edges and inside their triangles, and swaps diagonals, to where normals
/// interpolated over the small triangles come closer to the surface's own in the poses. Depends only on the surface in
/// the triangles at an edge, and at a triangle's edges.
/// @param next  as for findLevels().  @param tolerance  of positions, world units
/// @param known  the former splits; {} for triangles whose surface has changed
[[nodiscard]] AlignedSplits alignSplits(const Preparation& next, const std::vector<Pose>& poses, float tolerance,
                                        const RefinementLevels& levels, AlignedSplits known);

}  // namespace sinew
