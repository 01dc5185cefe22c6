// core/surface/roots/shaped_ray.h: where a ray is inside a shaped primitive, and 1 - r^2 there as a polynomial.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <span>

#include "core/surface/roots/polynomial.h"
#include "sinew/geometry/ellipsoid.h"

namespace sinew {

/// An interval of a ray inside an influence, on one side of each end of the core: r^2 is one polynomial there.
struct ShapedStretch {
  double enter = 0.0;
  double leave = 0.0;
  bool goesOn = false;  ///< Another interval begins where this one ends; the common point belongs to it.
};

/// The intervals of one ray with t >= 0, ascending: at most three from each of three parts.
class ShapedStretches {
 public:
  void add(const ShapedStretch& stretch) {
    assert(count_ < items_.size());
    items_[count_++] = stretch;
  }
  [[nodiscard]] std::span<const ShapedStretch> items() const { return std::span(items_).first(count_); }
  [[nodiscard]] ShapedStretch& last() { return items_[count_ - 1]; }
  void markJoined(std::size_t index) { items_[index].goesOn = true; }

 private:
  std::array<ShapedStretch, 9> items_{};
  std::size_t count_ = 0;
};

/// A ray in the unit space of a shaped primitive. Degree of r^2: 2 with a core alone, 3 belly, 4 bend, 5 both.
struct ShapedRay {
  UnitShape shape;
  glm::dvec3 start{0.0};
  glm::dvec3 along{0.0};  ///< Per world unit.

  ShapedRay(const UnitBallMap& influence, const glm::vec3& origin, const glm::vec3& direction);

  [[nodiscard]] glm::dvec3 at(double t) const { return start + t * along; }
  [[nodiscard]] bool isQuadratic() const;                      ///< Whether r^2 is a quadratic on every interval.
  [[nodiscard]] RayQuadratic quadraticAround(double t) const;  ///< r^2 on the interval around t, if isQuadratic().
  /// 1 - r^2 from `begin` to `end`, within one interval.
  [[nodiscard]] Bernstein insideness(double begin, double end) const;
  [[nodiscard]] ShapedStretches stretches() const;
};

}  // namespace sinew
