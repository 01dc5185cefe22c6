// core/include/sinew/geometry/ellipsoid.h: an oriented ellipsoid or shape on a bone and in world space.
#pragma once

#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "sinew/geometry/geometry.h"
#include "sinew/geometry/shape.h"

namespace sinew {

/// Place and shape of an ellipsoid; not a matrix, so nothing needs decomposing. Bone space, character units.
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

/// Form of an influence in the world, by which r^2 is computed.
enum class UnitForm : std::uint8_t { kEllipsoid, kSphere, kShape };

/// The affine map from the world to the unit space of an influence; for an ellipsoid |toUnit (x - center)| < 1 inside.
/// Center and map are separate, since x^T Q x about a far origin would cancel.
struct UnitBallMap {
  glm::mat3 toUnit{1.0f};
  glm::vec3 center{0.0f};       ///< World.
  float boundingRadius = 0.0f;  ///< World; radius of a ball around center that contains the influence.
  float inverseRadius = 0.0f;   ///< 1 / radius for a sphere, the factor in toUnit; 0 otherwise.
  float meanRadius = 0.0f;      ///< World; radius of the ball with the visible body's volume, times the reach.
  UnitForm form = UnitForm::kEllipsoid;
  UnitShape shape{};  ///< For kShape.

  [[nodiscard]] bool isPlain() const { return form != UnitForm::kShape; }  ///< An ellipsoid or a sphere.

  /// r^2 at a point: < 1 inside.
  [[nodiscard]] float rSquared(const glm::vec3& point) const {
    const glm::vec3 d = point - center;
    if (form == UnitForm::kShape) return shapedRSquared(d);
    if (form == UnitForm::kSphere) return inverseRadius * inverseRadius * glm::dot(d, d);
    const glm::vec3 y = toUnit * d;
    return glm::dot(y, y);
  }

  /// d(r^2)/dx inside the influence; for an ellipsoid 2 A^T A (x - c).
  [[nodiscard]] glm::vec3 rSquaredSlope(const glm::vec3& point) const {
    const glm::vec3 d = point - center;
    if (form == UnitForm::kShape) return shapedSlope(d);
    if (form == UnitForm::kSphere) return 2.0f * inverseRadius * inverseRadius * d;
    return 2.0f * (glm::transpose(toUnit) * (toUnit * d));
  }

  /// r^2 at origin + t direction, world. Only for ellipsoids (isPlain()).
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

  // Not inline, to keep the code for ellipsoids short.
  [[nodiscard]] float shapedRSquared(const glm::vec3& fromCenter) const;
  [[nodiscard]] glm::vec3 shapedSlope(const glm::vec3& fromCenter) const;

  /// Whether the influence contains a point; a flat one contains none.
  [[nodiscard]] bool holds(const glm::vec3& point) const { return boundingRadius > 0.0f && rSquared(point) < 1.0f; }
};

/// World -> unit space of the influence, for any 3x4 bone matrix. A flat bone gives a map of zeros and boundingRadius
/// 0: no influence.
[[nodiscard]] UnitBallMap unitBallMap(const Placement& inBone, float reach, const glm::mat4& boneInWorld);

/// Unit ball -> world for drawing: boneInWorld * T * R * S(radii * scale), after onShape() for shapes.
[[nodiscard]] glm::mat4 shapeInWorld(const Placement& inBone, float scale, const glm::mat4& boneInWorld);

}  // namespace sinew
