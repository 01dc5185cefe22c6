// core/surface/patches/sample_points.h: refined vertices without the triangles between them.
#pragma once

#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Vertices along edges and inside triangles, evenly spaced as in an n^2 split, each piece by its own number; no
/// triangles, nothing drawn.  @param samples  0 as 1: none
[[nodiscard]] Refinement samplePoints(const ControlMesh& mesh, const RefinementLevels& samples);

}  // namespace sinew
