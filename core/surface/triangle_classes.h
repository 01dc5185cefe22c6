// core/surface/triangle_classes.h: implicit, straddling and normal control triangles (paper 3).
#pragma once

#include <span>
#include <vector>

#include "core/surface/projection/carrier_walk.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// Implicit where omega is 1 at all three corners, normal where it is 0 at all, straddling between.
/// @param omega [V] 0 or 1.  @return [T]
[[nodiscard]] std::vector<TriangleClass> classifyTriangles(const ControlMesh& mesh, std::span<const float> omega);

/// omega in `swell`, where only the overlay and the report ask: 1 inside some influence, else 0.  @return [V]
[[nodiscard]] std::vector<float> influenceWeights(const ControlMesh& mesh, const FieldView& bindField);

}  // namespace sinew
