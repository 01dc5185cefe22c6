// core/surface/region_levels.h: refinement of a part of the body, the rest as coarse as its control mesh.
#pragma once

#include "sinew/surface/refinement.h"
#include "sinew/surface/region.h"

namespace sinew {

/// Control triangles around a region that are refined with it: what is done about folds and steep skin looks around,
/// seldom further than this.
inline constexpr int kRegionMargin = 3;

/// Levels of the region and of its margin as they are, all others 1. Edges at refined triangles keep theirs, so that
/// nothing opens between the two.
/// @param region [T]
[[nodiscard]] RefinementLevels inRegion(const ControlMesh& mesh, RefinementLevels levels, const Region& region);

}  // namespace sinew
