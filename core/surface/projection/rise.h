// core/surface/projection/rise.h: directions of rising skin, and how far it can rise. docs/design.md, Rise limits.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/geometry/potential.h"
#include "sinew/geometry/control_mesh.h"

namespace sinew {

inline constexpr float kRise = 0.1f;  ///< Height that skin should be able to rise out of a crease, fraction of H.

/// The vertex normals of the bind pose, relaxed where they converge. Skin lifted by s along two converging normals
/// crosses itself once s times their difference exceeds the distance of the vertices. So the converging component is
/// averaged away along every edge until skin can rise by `rise`. Diverging and parallel normals stay as they are, to
/// the bit. A direction stays within 60 degrees of its normal. Independent of the order of vertices and triangles, up
/// to rounding.
/// @param rise  world units, > 0: height that skin should reach without crossing.  @return [V] bind pose, unit.
[[nodiscard]] std::vector<glm::vec3> riseDirections(const ControlMesh& mesh, float rise);

/// 1/L of every control vertex in the bind pose, per world unit; 0: no limit. L is the least height, over all points q
/// of the mesh, at which skin rising from p along d_p meets skin rising from q along d_q:
/// |q-p|^2 / ((d_p - d_q) . (q-p)). Between facing walls that is half their gap; diverging directions have none. Points
/// are vertices and, on large triangles, points between them; dense points with similar directions are thinned to one
/// in 0.15 `most`. Limits above `most` fade out up to 3/2 of it. Independent of the order of vertices and triangles.
/// @param directions [V] unit, from riseDirections().  @param most  world units, > 0.  @return [V] >= 0.
[[nodiscard]] std::vector<float> inverseRiseLimits(const ControlMesh& mesh, std::span<const glm::vec3> directions,
                                                   float most);

}  // namespace sinew
