// core/surface/projection/rise_directions.h: the directions along which muscles lift the skin.
#pragma once

#include <vector>

#include "sinew/geometry/control_mesh.h"

namespace sinew {

inline constexpr float kRise = 0.1f;  ///< How far skin should be able to rise out of a crease, fraction of H.

/// The vertex normals of the bind pose, relaxed where they converge. Skin lifted by s along two normals that lean
/// together crosses itself once s times their difference exceeds the distance of the vertices. Along every edge the
/// component that converges is therefore averaged away until skin can rise by `rise`; where normals diverge or run
/// parallel they are kept bit for bit. A direction stays within 60 degrees of its normal.
/// Independent of the order of vertices and triangles, up to rounding.
/// @param rise  world units, > 0: how far skin should be able to rise without crossing.  @return [V] bind pose, unit.
[[nodiscard]] std::vector<glm::vec3> riseDirections(const ControlMesh& mesh, float rise);

}  // namespace sinew
