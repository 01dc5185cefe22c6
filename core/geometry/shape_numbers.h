// core/geometry/shape_numbers.h: the numbers of a shape as a table, for all that treats them alike: files, limits,
// mirror images, keys and drivers, the inspector, shaders.
#pragma once

#include <span>
#include <utility>

#include "sinew/geometry/shape.h"

namespace sinew {

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

}  // namespace sinew
