// core/include/sinew/geometry/ellipsoid.h: an oriented ellipsoid on a bone, or a shape made of one, and the same in
// world space.
#pragma once

#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "sinew/geometry/geometry.h"
#include "sinew/geometry/shape.h"

namespace sinew {

/// Where an ellipsoid sits and how it is shaped: typed parts, never a matrix, so that nothing ever needs decomposing.
/// Bone space, character units.
struct Placement {
  glm::vec3 center{0.0f};
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< Unit; primitive axes -> bone axes.
  glm::vec3 radii{1.0f};                       ///< Visible semi-axes, each > 0.
  Shape shape{};                               ///< Along the y axis.

  friend bool operator==(const Placement&, const Placement&) = default;
};

/// r^2 along a ray: a t^2 + 2 b t + c.
struct RayQuadratic {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
};

/// What an influence is in the world: which way its r^2 is computed.
enum class UnitForm : std::uint8_t { kEllipsoid, kSphere, kShape };

/// An influence in the world as the affine map that takes an ellipsoid's to the unit ball, |toUnit (x - center)| < 1
/// inside, and any other's to its unit space. Center and map are kept apart: x^T Q x about a far origin would cancel.
struct UnitBallMap {
  glm::mat3 toUnit{1.0f};
  glm::vec3 center{0.0f};       ///< World.
  float boundingRadius = 0.0f;  ///< World; a ball around center of this radius holds the influence.
  /// 1 / radius where the ellipsoid is a sphere in the world: then toUnit is only this factor, and distances come
  /// without a matrix. 0 otherwise.
  float inverseRadius = 0.0f;
  float meanRadius = 0.0f;  ///< World: of the ball with the visible body's volume, times the reach.
  UnitForm form = UnitForm::kEllipsoid;
  UnitShape shape{};  ///< Where form is kShape.

  /// An ellipsoid or a sphere.
  [[nodiscard]] bool isPlain() const { return form != UnitForm::kShape; }

  /// r^2 at a point: < 1 inside.
  [[nodiscard]] float rSquared(const glm::vec3& point) const {
    const glm::vec3 d = point - center;
    if (form == UnitForm::kShape) return shapedRSquared(d);
    if (form == UnitForm::kSphere) return inverseRadius * inverseRadius * glm::dot(d, d);
    const glm::vec3 y = toUnit * d;
    return glm::dot(y, y);
  }

  /// d(r^2)/dx, inside the influence = 2 A^T A (x - c) of an ellipsoid; on a sphere A^T A is a number.
  [[nodiscard]] glm::vec3 rSquaredSlope(const glm::vec3& point) const {
    const glm::vec3 d = point - center;
    if (form == UnitForm::kShape) return shapedSlope(d);
    if (form == UnitForm::kSphere) return 2.0f * inverseRadius * inverseRadius * d;
    return 2.0f * (glm::transpose(toUnit) * (toUnit * d));
  }

  /// r^2 at origin + t direction, world. Of an ellipsoid alone (isPlain()).
  [[nodiscard]] RayQuadratic alongRay(const glm::vec3& origin, const glm::vec3& direction) const {
    glm::dvec3 y(origin - center);
    glm::dvec3 yd(direction);
    double scale = 1.0;
    if (inverseRadius > 0.0f) {
      scale = static_cast<double>(inverseRadius) * static_cast<double>(inverseRadius);
    } else {
      const glm::dmat3 linear(toUnit);
      y = linear * y;
      yd = linear * yd;
    }
    return {scale * glm::dot(yd, yd), scale * glm::dot(y, yd), scale * glm::dot(y, y)};
  }

  // Apart, so that ellipsoids keep the short way.
  [[nodiscard]] float shapedRSquared(const glm::vec3& fromCenter) const;
  [[nodiscard]] glm::vec3 shapedSlope(const glm::vec3& fromCenter) const;

  /// Whether the influence holds a point; a flattened one holds none.
  [[nodiscard]] bool holds(const glm::vec3& point) const { return boundingRadius > 0.0f && rSquared(point) < 1.0f; }
};

/// World -> unit space of the influence, after the whole 3x4 bone matrix, uneven scale included.
/// A flattened bone gives a map of zeros and boundingRadius 0: such a primitive reaches nothing.
[[nodiscard]] UnitBallMap unitBallMap(const Placement& inBone, float reach, const glm::mat4& boneInWorld);

/// Unit ball -> world for drawing: boneInWorld * T * R * S(radii * scale). Shapes are onShape() before it.
[[nodiscard]] glm::mat4 shapeInWorld(const Placement& inBone, float scale, const glm::mat4& boneInWorld);

}  // namespace sinew
