// core/primitives/ellipsoid.cpp: placements through bone matrices.
#include "sinew/primitives/ellipsoid.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/base/flatness.h"

namespace sinew {
namespace {

constexpr double kRound = 4e-6;  ///< Relative: rounding in a bone's matrix does not unmake a sphere.

/// The radius of the ball that the axes span, or 0 if they are not alike and square to each other.
double ballRadius(const glm::dmat3& axes) {
  const double radius = std::cbrt(std::abs(glm::determinant(axes)));
  const double square = radius * radius;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(glm::dot(axes[i], axes[i]) - square) > kRound * square) return 0.0;
    if (std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) > kRound * square) return 0.0;
  }
  return radius;
}

/// Radius of a ball around the origin that holds the image of the unit ball: axes are its columns.
double ballAround(const glm::dmat3& axes) {
  // Half extents of the world box around the ellipsoid: row norms of the axes.
  glm::dvec3 half(0.0);
  for (int row = 0; row < 3; ++row) {
    half[row] = std::sqrt(axes[0][row] * axes[0][row] + axes[1][row] * axes[1][row] + axes[2][row] * axes[2][row]);
  }
  const double frobenius =
      std::sqrt(glm::dot(axes[0], axes[0]) + glm::dot(axes[1], axes[1]) + glm::dot(axes[2], axes[2]));
  return std::min(glm::length(half), frobenius);
}

/// Largest length that the map of two columns gives a unit vector.
double mostStretch(const glm::dvec3& a, const glm::dvec3& b) {
  const double mean = 0.5 * (glm::dot(a, a) + glm::dot(b, b));
  const double half = 0.5 * (glm::dot(a, a) - glm::dot(b, b));
  return std::sqrt(mean + std::hypot(half, glm::dot(a, b)));
}

/// The same of a shape's influence.
double ballAround(const glm::dmat3& axes, const UnitShape& shape) {
  const double along = static_cast<double>(shape.high.y);
  const double core = static_cast<double>(shape.core);
  const glm::dvec3 middle = axes[0] * static_cast<double>(shape.bend.x) + axes[2] * static_cast<double>(shape.bend.y);
  const glm::dvec3 curve =
      (axes[0] * static_cast<double>(shape.curve.x) + axes[2] * static_cast<double>(shape.curve.y)) * (along * along);
  // As a tube around the axis, a parabola that lies within its three control points.
  const double lateral =
      0.5 * static_cast<double>(shape.high.x - shape.low.x - std::abs(shape.curve.x) * shape.high.y * shape.high.y);
  const double around = mostStretch(axes[0], axes[2]) * lateral;
  double tube = glm::length(middle - curve);
  // As an ellipsoid as wide as the section could be at the thick end, moved along the core and the bend.
  const double thinnest = static_cast<double>(shape.lateral) - std::abs(static_cast<double>(shape.taper)) * along;
  const double widest = 1.0 / std::sqrt(thinnest);
  const double end = ballAround({axes[0] * widest, axes[1] / static_cast<double>(shape.inverseEnd), axes[2] * widest});
  double moved = 0.0;
  for (const double side : {-1.0, 1.0}) {
    tube = std::max(tube, glm::length(middle + curve + side * along * axes[1]));
    moved = std::max(
        {moved, glm::length(middle + side * core * axes[1]), glm::length(middle + curve + side * core * axes[1])});
  }
  return std::min(tube + around, moved + end);
}

}  // namespace

float UnitBallMap::shapedRSquared(const glm::vec3& fromCenter) const { return shape.rSquared(toUnit * fromCenter); }

glm::vec3 UnitBallMap::shapedSlope(const glm::vec3& fromCenter) const {
  return glm::transpose(toUnit) * shape.rSquaredSlope(toUnit * fromCenter);
}

UnitBallMap unitBallMap(const Placement& inBone, float reach, const glm::mat4& boneInWorld) {
  // In double: a bone in metres under a parent scaled by 0.01 loses digits that the field would show.
  const glm::dmat3 bone{glm::mat3(boneInWorld)};
  const glm::dmat3 rotation = glm::mat3_cast(glm::dquat(inBone.rotation));
  glm::dmat3 axes = bone * rotation;
  for (int i = 0; i < 3; ++i) axes[i] *= static_cast<double>(inBone.radii[i] * reach);

  UnitBallMap map;
  map.center = glm::vec3(boneInWorld * glm::vec4(inBone.center, 1.0f));
  map.shape = unitShape(inBone.shape, reach);
  if (!map.shape.isPlain) map.form = UnitForm::kShape;
  if (isFlat(axes)) {
    map.toUnit = glm::mat3(0.0f);
    map.boundingRadius = 0.0f;
    return map;
  }
  if (const double radius = map.isPlain() ? ballRadius(axes) : 0.0; radius > 0.0) {
    // However it is turned, a sphere is the same: no rotation is left in its map.
    map.form = UnitForm::kSphere;
    map.inverseRadius = static_cast<float>(1.0 / radius);
    map.toUnit = glm::mat3(map.inverseRadius);
    map.boundingRadius = static_cast<float>(radius * (1.0 + kRound));
    map.meanRadius = static_cast<float>(radius);
    return map;
  }
  map.toUnit = glm::mat3(glm::inverse(axes));
  map.meanRadius = static_cast<float>(std::cbrt(std::abs(glm::determinant(axes))));
  map.meanRadius *= map.shape.meanRadius;
  const double around = map.isPlain() ? ballAround(axes) : ballAround(axes, map.shape);
  map.boundingRadius = static_cast<float>(around * (1.0 + 1e-6));
  return map;
}

glm::mat4 shapeInWorld(const Placement& inBone, float scale, const glm::mat4& boneInWorld) {
  const glm::mat4 moved = glm::translate(boneInWorld, inBone.center) * glm::mat4_cast(inBone.rotation);
  return glm::scale(moved, inBone.radii * scale);
}

}  // namespace sinew
