// core/include/sinew/geometry/shape.h: shapes between ellipsoid, capsule, egg and bent spindle. docs/design.md.
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

/// Difference of a primitive from an ellipsoid, along its y axis. In its space divided by the radii (x, y, z), with
/// e = 1 - core and S(y) = 1 - 2 belly y + belly^2, the distance measure is
///     rho^2 = nu S(y) |(x, z) - bend (1 - y^2)|^2 + (max(|y| - core, 0) / e)^2,
/// visible at rho = 1. nu makes the largest lateral radius 1.
struct Shape {
  float core = 0.0f;     ///< Half the length of the straight part over the radius y, 0..kMostCore.
  float belly = 0.0f;    ///< Place of the thickest section: y = belly if core = 0. At most mostBelly(), +-.
  glm::vec2 bend{0.0f};  ///< Displacement of the middle of the axis in radii x and z; -kMostBend..kMostBend each.

  [[nodiscard]] bool isPlain() const { return *this == Shape{}; }  ///< An ellipsoid.
  friend bool operator==(const Shape&, const Shape&) = default;
};

/// Count of a shape's numbers, which core/geometry/affine_image.h describes.
inline constexpr int kShapeNumbers = sizeof(Shape) / sizeof(float);

/// Largest absolute value of `belly`, so that S is positive in the whole influence. reach > 1.
[[nodiscard]] float mostBelly(float core, float reach);
/// The shape with each number clamped to its range; numbers that are not finite become 0.
[[nodiscard]] Shape legalShape(const Shape& shape, float reach);

[[nodiscard]] float thickestAt(const Shape& shape);  ///< y of the thickest section, whose lateral radii are exactly 1.
/// Radius of the visible section at y, relative to the lateral radii.
[[nodiscard]] float sectionAt(const Shape& shape, float y);
[[nodiscard]] glm::vec2 axisAt(const Shape& shape, float y);  ///< Place of the axis at y, in radii x and z.

/// Maps the unit sphere onto the surface rho = scale, in the primitive's space divided by its radii; continuous, and
/// the identity times `scale` for an ellipsoid. Poles map to the ends of the axis, points next to the equator to the
/// straight part.
[[nodiscard]] glm::vec3 onShape(const Shape& shape, float scale, const glm::vec3& onSphere);

/// A shape in the unit space of its influence, with lengths divided by radii times reach: r^2 = (rho / k)^2.
struct UnitShape {
  bool isPlain = true;   ///< r^2 is the squared length; other members do not apply.
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
  [[nodiscard]] float rSquared(const glm::vec3& p) const;
  [[nodiscard]] double rSquared(const glm::dvec3& p) const;
  /// d(r^2)/dp inside the influence.
  [[nodiscard]] glm::vec3 rSquaredSlope(const glm::vec3& p) const;
  [[nodiscard]] glm::dvec3 rSquaredSlope(const glm::dvec3& p) const;
};

[[nodiscard]] UnitShape unitShape(const Shape& shape, float reach);  ///< @param shape  legal for the reach.

/// Radius of a ball around the center that contains the influence. @param axes  images of the unit space's axes.
[[nodiscard]] double ballAround(const UnitShape& shape, const glm::dmat3& axes);

}  // namespace sinew
