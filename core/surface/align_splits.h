// core/surface/align_splits.h: vertices and edges inside control triangles follow rims and valleys.
// docs/design.md, Detail.
#pragma once

#include <vector>

#include "core/surface/patches/triangulation.h"
#include "core/surface/triangle_samples.h"

namespace sinew {

/// Moves the points of splits along their edges and inside their triangles, and swaps diagonals, to where normals
/// interpolated over the small triangles come closer to the surface's own in the triangles' poses. Depends only on the
/// surface in the triangles at an edge, and at a triangle's edges.
/// @param surface  of the mesh that the levels are of.  @param tolerance  of positions, world units
/// @param known  the former splits; {} for triangles whose surface has changed
[[nodiscard]] AlignedSplits alignSplits(const ControlMesh& mesh, SampledSurface& surface, float tolerance,
                                        const RefinementLevels& levels, AlignedSplits known);

}  // namespace sinew
