// core/include/sinew/geometry/shape.h: what makes a capsule, an egg or a bent spindle of an ellipsoid. docs/design.md.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sinew/geometry/same_version.h"

namespace sinew {

inline constexpr float kMostCore = 0.95f;
inline constexpr float kMostBend = 1.0f;

/// How a primitive differs from an ellipsoid, along its own y axis. In its space divided by the radii (x, y, z), with
/// e = 1 - core and S(y) = 1 - 2 belly y + belly^2, the distance measure is
///     rho^2 = nu S(y) |(x, z) - bend (1 - y^2)|^2 + (max(|y| - core, 0) / e)^2,
/// visible where rho = 1. nu makes the largest lateral radius 1.
struct Shape {
  float core = 0.0f;     ///< Straight part: half its length over the radius y, 0..kMostCore.
  float belly = 0.0f;    ///< Where the thickest place is: at y = belly if core = 0. At most mostBelly() either way.
  glm::vec2 bend{0.0f};  ///< By how much the middle of the axis is moved, in radii x and z; -kMostBend..kMostBend each.

  /// An ellipsoid.
  [[nodiscard]] bool isPlain() const { return *this == Shape{}; }
  friend bool operator==(const Shape&, const Shape&) = default;
};

/// How many numbers a shape has: core/geometry/affine_image.h describes each.
inline constexpr int kShapeNumbers = sizeof(Shape) / sizeof(float);

/// The most that `belly` may be either way: S stays positive wherever the influence reaches. reach > 1.
[[nodiscard]] float mostBelly(float core, float reach);
/// The shape with each number brought into its range. A number that is not finite becomes 0.
[[nodiscard]] Shape legalShape(const Shape& shape, float reach);

/// y of the thickest section, where the lateral radii are exactly 1.
[[nodiscard]] float thickestAt(const Shape& shape);
/// Radius of the visible section at y, over the radii across.
[[nodiscard]] float sectionAt(const Shape& shape, float y);
/// Where the axis is at y, in radii x and z.
[[nodiscard]] glm::vec2 axisAt(const Shape& shape, float y);

/// The point of the surface rho = scale that belongs to a point of the unit sphere, in the primitive's space divided by
/// its radii; onto, continuous, and the identity times `scale` for an ellipsoid. Poles go to the ends of the axis, the
/// points next to the equator to the straight part.
[[nodiscard]] glm::vec3 onShape(const Shape& shape, float scale, const glm::vec3& onSphere);

/// A shape in the unit space of its influence, where all lengths are divided by radii times reach: r^2 = (rho / k)^2.
struct UnitShape {
  bool isPlain = true;   ///< r^2 is the squared length; the rest is not read.
  float lateral = 1.0f;  ///< nu S(y) = lateral + taper y.
  float taper = 0.0f;
  glm::vec2 bend{0.0f};  ///< The axis is at bend + curve y^2.
  glm::vec2 curve{0.0f};
  float core = 0.0f;        ///< Half the length of the straight part.
  float inverseEnd = 1.0f;  ///< 1 / e
  glm::vec3 low{-1.0f};     ///< A box around the influence.
  glm::vec3 high{1.0f};
  float meanRadius = 1.0f;  ///< Radius of the ball with the visible body's volume, over that of the ellipsoid's.

  /// r^2 at a point: < 1 inside the influence.
  template <class Vec>
  [[nodiscard]] typename Vec::value_type rSquared(const Vec& p) const {
    using Real = typename Vec::value_type;
    const Real end = std::max(std::abs(p.y) - Real(core), Real(0)) * Real(inverseEnd);
    if (end >= Real(1)) return end * end;  // S may be negative there.
    const Real x = p.x - Real(bend.x) - Real(curve.x) * p.y * p.y;
    const Real z = p.z - Real(bend.y) - Real(curve.y) * p.y * p.y;
    return (Real(lateral) + Real(taper) * p.y) * (x * x + z * z) + end * end;
  }

  /// d(r^2)/dp inside the influence.
  template <class Vec>
  [[nodiscard]] Vec rSquaredSlope(const Vec& p) const {
    using Real = typename Vec::value_type;
    const Real end = std::max(std::abs(p.y) - Real(core), Real(0)) * Real(inverseEnd);
    const Real x = p.x - Real(bend.x) - Real(curve.x) * p.y * p.y;
    const Real z = p.z - Real(bend.y) - Real(curve.y) * p.y * p.y;
    const Real twice = Real(2) * (Real(lateral) + Real(taper) * p.y);
    const Real alongAxis = Real(taper) * (x * x + z * z) -
                           twice * Real(2) * p.y * (Real(curve.x) * x + Real(curve.y) * z) +
                           Real(2) * end * Real(inverseEnd) * (p.y < Real(0) ? Real(-1) : Real(1));
    return {twice * x, alongAxis, twice * z};
  }
};

/// @param shape  legal for the reach.
[[nodiscard]] UnitShape unitShape(const Shape& shape, float reach);

/// Radius of a ball around the center that holds the influence. @param axes  images of the unit space's axes.
[[nodiscard]] double ballAround(const UnitShape& shape, const glm::dmat3& axes);

}  // namespace sinew
