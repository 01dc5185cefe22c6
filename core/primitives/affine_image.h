// core/primitives/affine_image.h: the ellipsoid that an affine map makes of another.
#pragma once

#include "sinew/primitives/ellipsoid.h"

namespace sinew {

/// x -> linear x + offset, say from one bone's space to another's.
struct AffineMap {
  glm::dmat3 linear{1.0};
  glm::dvec3 offset{0.0};
};

/// The image of an ellipsoid: exact for every map, uneven scale and shear included. Of the many placements an ellipsoid
/// has, the one that keeps what the designer sees: radii and axes keep their numbers under a turn with even scale, and
/// under a turn-over the image's image is the original. Where the map stretches unevenly each axis is the principal
/// axis of the image nearest to the old one's; which of them is called x may change.
/// @param map  finite, not flattened (base/flatness.h); else radii may be 0.
[[nodiscard]] Placement imageOf(const Placement& placement, const AffineMap& map);

}  // namespace sinew
