// core/surface/projection/rise.h: how far skin can rise before it meets skin that rises towards it.
// docs/design.md, Rise limits.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/geometry/potential.h"
#include "sinew/geometry/control_mesh.h"

namespace sinew {

// The directions along which muscles lift the skin.

inline constexpr float kRise = 0.1f;  ///< How far skin should be able to rise out of a crease, fraction of H.

/// The vertex normals of the bind pose, relaxed where they converge. Skin lifted by s along two normals that lean
/// together crosses itself once s times their difference exceeds the distance of the vertices. Along every edge the
/// component that converges is therefore averaged away until skin can rise by `rise`; where normals diverge or run
/// parallel they are kept bit for bit. A direction stays within 60 degrees of its normal.
/// Independent of the order of vertices and triangles, up to rounding.
/// @param rise  world units, > 0: how far skin should be able to rise without crossing.  @return [V] bind pose, unit.
[[nodiscard]] std::vector<glm::vec3> riseDirections(const ControlMesh& mesh, float rise);

/// 1/L of every control vertex in the bind pose, per world unit; 0: no limit. L is the height at which skin that rises
/// from p along d_p, and from any other point q of the mesh along d_q, meets: |q-p|^2 / ((d_p - d_q) . (q-p)), the
/// least over all q. Between two facing walls that is half their gap; where directions diverge there is none. Points
/// are vertices and, on large triangles, points between; where they are dense, one in 0.15 `most` stands for those that
/// face the same way. Limits above `most` fade out up to 3/2 of it.
/// Independent of the order of vertices and triangles.
/// @param directions [V] unit (rise_directions.h).  @param most  world units, > 0.  @return [V] >= 0.
[[nodiscard]] std::vector<float> inverseRiseLimits(const ControlMesh& mesh, std::span<const glm::vec3> directions,
                                                   float most);

/// A height s under the limit L: s itself up to L/2, from there on L - (L/2)^2 / s, which never reaches L. C1.
[[nodiscard]] inline float limitedRise(float s, float inverseLimit) {
  if (!(s * inverseLimit > 0.5f)) return s;
  const float limit = 1.0f / inverseLimit;
  return limit - 0.25f * limit * limit / s;
}

/// 1/L over muscles and carves that the skin only touches: twice the height, or depth, at which the root would lie if F
/// stayed as it is on the skin. Over muscles it fades from F = T/2 to 0, no limit, at T, where the skin is inside. What
/// a shell has just reached so moves from 0, whatever stands further out or in.
/// @param onSkin  F there, not 0.  @param width  W of the skin's field.
[[nodiscard]] inline float inverseTouchLimit(float onSkin, float iso, float width) {
  if (!(onSkin < iso)) return 0.0f;
  const float left = std::sqrt(std::min(1.0f, iso - onSkin));
  // |r - r_T| at g(r) = T - F, without cancelling.
  const float further = std::abs(onSkin) / ((isoRoot(iso) + left) * (std::sqrt(1.0f - left) + isoRadius(iso)));
  return (1.0f - smoothstep(0.5f * iso, iso, onSkin)) / (2.0f * width * further);
}

}  // namespace sinew
