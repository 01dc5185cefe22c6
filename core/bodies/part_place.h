// core/bodies/part_place.h: where a point lies about the axis of a part of the body.
#pragma once

#include "core/bodies/body_frame.h"

namespace sinew {

/// Cylinder coordinates round an axis that may have bends.
struct PartPlace {
  float u = 0.0f;       ///< Along the part, as Mark::u.
  float angle = 0.0f;   ///< Degrees, as Mark::angle. 0 on the axis, where there is none.
  float away = 0.0f;    ///< From the axis.
  float beside = 0.0f;  ///< Along the part from the level of u: not 0 where a bend of the axis leaves no level.
};

/// Of H: so near the axis there is no angle.
inline constexpr float kOnAxis = 1e-5f;

/// @param leastAway  nearer than this there is no angle
[[nodiscard]] PartPlace placeAt(const PartAxis& axis, const glm::vec3& point, float leastAway);

/// Unit axes there: away from the axis, round it, along it.
[[nodiscard]] glm::mat3 axesAt(const PartAxis& axis, float u, float angle);

}  // namespace sinew
