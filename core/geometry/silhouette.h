// core/geometry/silhouette.h: the outline of a shaped primitive as seen from a point or from afar.
#pragma once

#include <array>

#include <glm/mat4x4.hpp>

#include "sinew/geometry/shape.h"

namespace sinew {

inline constexpr int kSilhouettePoints = 96;  ///< As shaders/outline.vert counts them.

/// Points around the visible body where it turns away from the eye, in order, world space.
using Silhouette = std::array<glm::vec3, kSilhouettePoints>;

/// All points are equal if the eye is inside. @param unitBallInWorld  as shapeInWorld() (sinew/geometry/ellipsoid.h).
/// @param eye  world; if `parallel`, the direction of sight.
[[nodiscard]] Silhouette silhouetteOf(const Shape& shape, const glm::mat4& unitBallInWorld, const glm::vec3& eye,
                                      bool parallel);

}  // namespace sinew
