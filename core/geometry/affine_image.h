// core/geometry/affine_image.h: the ellipsoid, or the shape, that an affine map makes of another.
#pragma once

#include "sinew/geometry/ellipsoid.h"

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
/// A shape goes along, exactly under a turn or turn-over with even scale. Where the map stretches unevenly its y axis
/// goes where the map takes it, and its sections are laid square to that, of the same area; the shear is left out.
/// @param map  finite, not flattened (base/flatness.h); else radii may be 0.
[[nodiscard]] Placement imageOf(const Placement& placement, const AffineMap& map);

/// The same ellipsoid, called so that its longest axis is y: axes go round, x to y to z or back. A shape stays: it has
/// its y axis.
[[nodiscard]] Placement withLongAxisY(const Placement& placement);

}  // namespace sinew
