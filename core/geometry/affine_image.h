// core/geometry/affine_image.h: the table of a shape's numbers; images of shapes under affine maps.
#pragma once

#include <span>
#include <utility>

#include "sinew/geometry/ellipsoid.h"
#include "sinew/geometry/shape.h"

namespace sinew {

/// A number of a shape, for files, limits, mirror images, keys, drivers, the inspector and shaders.
struct ShapeNumber {
  static constexpr int kNoAxis = -1;

  const char* key;     ///< In files; adjacent numbers with the same key form a list there.
  const char* name;    ///< In keys and drivers: "bend.x".
  const char* words;   ///< Label: "Bend X".
  const char* change;  ///< In the history, before the muscle's name: "Move the belly of".
  const char* hint;
  float& (*member)(Shape& shape);
  float low;  ///< Range regardless of the other numbers; contains 0, the ellipsoid's value.
  float high;
  /// The primitive's axis with which it changes sign. The numbers of one key along x and z are components of a vector
  /// in radii. kNoAxis: the same in every image.
  int axis = kNoAxis;
  /// Largest absolute value that the reach and numbers earlier in the table allow; null: no further limit.
  float (*most)(const Shape& shape, float reach) = nullptr;

  [[nodiscard]] float of(const Shape& shape) const { return member(const_cast<Shape&>(shape)); }
  [[nodiscard]] std::pair<float, float> range(const Shape& shape, float reach) const;
};

[[nodiscard]] std::span<const ShapeNumber, kShapeNumbers> shapeNumbers();  ///< In the order of Shape's members.
[[nodiscard]] std::span<const std::span<const ShapeNumber>> shapeKeys();   ///< Grouped by key.

/// x -> linear x + offset.
struct AffineMap {
  glm::dmat3 linear{1.0};
  glm::dvec3 offset{0.0};
};

/// The image of an ellipsoid, exact for every map, including non-uniform scale and shear. Among the placements of the
/// image it is the one most like the original: radii and axes keep their order under a rotation with uniform scale, and
/// the image of the image under a reflection is the original. Under non-uniform scale each axis is the principal axis
/// nearest to the image of the old one, so their order may change.
/// The image of a shape is exact under a rotation or reflection with uniform scale. Otherwise its y axis is mapped and
/// its sections are made perpendicular to it with the same area, without shear.
/// @param map  finite, not flat (isFlat); else radii may be 0.
[[nodiscard]] Placement imageOf(const Placement& placement, const AffineMap& map);

/// The same ellipsoid with cyclically permuted axes, so that y is the longest. A shape that is no ellipsoid stays.
[[nodiscard]] Placement withLongAxisY(const Placement& placement);

}  // namespace sinew
