// core/include/sinew/geometry/geometry.h: vector types, boxes and small functions on vectors.
#pragma once

#include <limits>
#include <span>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// Axis-aligned box. Empty (isEmpty) until the first point is added.
struct Bounds {
  glm::vec3 low{std::numeric_limits<float>::infinity()};
  glm::vec3 high{-std::numeric_limits<float>::infinity()};

  [[nodiscard]] bool isEmpty() const { return low.x > high.x; }
  [[nodiscard]] glm::vec3 center() const { return 0.5f * (low + high); }
  [[nodiscard]] glm::vec3 extent() const { return high - low; }
  void add(const glm::vec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
};

[[nodiscard]] Bounds boundsOf(std::span<const glm::vec3> points);  ///< Smallest box around points; empty for none.

/// v / |v|, or fallback if v is too short or not finite.
[[nodiscard]] glm::vec3 normalizeOr(const glm::vec3& v, const glm::vec3& fallback);

/// The matrix for normals if `m` is that for points: inverse transpose up to a positive factor, by cofactors, so that a
/// flat bone (determinant 0) still gives a direction.
[[nodiscard]] glm::mat3 normalMatrix(const glm::mat3& m);

[[nodiscard]] bool isFinite(const glm::vec3& v);
[[nodiscard]] bool isFinite(const glm::mat4& m);

}  // namespace sinew
