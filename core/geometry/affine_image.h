// core/geometry/affine_image.h: the ellipsoid, or the shape, that an affine map makes of another.
#pragma once

#include <span>
#include <utility>

#include "sinew/geometry/ellipsoid.h"
#include "sinew/geometry/shape.h"

namespace sinew {

// The numbers of a shape as a table, for all that treats them alike: files, limits,
// mirror images, keys and drivers, the inspector, shaders.

struct ShapeNumber {
  static constexpr int kNoAxis = -1;

  const char* key;     ///< In files; numbers that share one stand side by side and make a list there.
  const char* name;    ///< In keys and drivers: "bend.x".
  const char* words;   ///< The number alone: "Bend X".
  const char* change;  ///< In the history, the muscle follows: "Move the belly of".
  const char* hint;
  float& (*member)(Shape& shape);
  float low;  ///< The range in which it lies whatever the others are; 0, the ellipsoid's, is in it.
  float high;
  /// The primitive's axis with which it changes its sign. Along x and z the numbers of one key are the parts of a
  /// vector in radii. kNoAxis: the same in every image.
  int axis = kNoAxis;
  /// The most either way that the reach and numbers before it in the table allow; null: the range is all.
  float (*most)(const Shape& shape, float reach) = nullptr;

  [[nodiscard]] float of(const Shape& shape) const { return member(const_cast<Shape&>(shape)); }
  /// From, to.
  [[nodiscard]] std::pair<float, float> range(const Shape& shape, float reach) const;
};

/// In the order of Shape's members.
[[nodiscard]] std::span<const ShapeNumber, kShapeNumbers> shapeNumbers();
/// The same, key by key.
[[nodiscard]] std::span<const std::span<const ShapeNumber>> shapeKeys();

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
