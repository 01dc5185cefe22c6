// core/geometry/ellipsoid.cpp: placements under bone matrices; boxes, normalizing, the matrix of normals.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/geometry/normals.h"
#include "sinew/geometry/ellipsoid.h"
#include "sinew/geometry/geometry.h"

namespace sinew {
namespace {

constexpr double kRound = 4e-6;  ///< Relative tolerance for rounding in a bone's matrix.

/// The radius of the ball that the axes span, or 0 if they are not equally long and perpendicular.
double ballRadius(const glm::dmat3& axes) {
  const double radius = std::cbrt(std::abs(glm::determinant(axes)));
  const double square = radius * radius;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(glm::dot(axes[i], axes[i]) - square) > kRound * square) return 0.0;
    if (std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) > kRound * square) return 0.0;
  }
  return radius;
}

}  // namespace

float UnitBallMap::shapedRSquared(const glm::vec3& fromCenter) const { return shape.rSquared(toUnit * fromCenter); }

glm::vec3 UnitBallMap::shapedSlope(const glm::vec3& fromCenter) const {
  return glm::transpose(toUnit) * shape.rSquaredSlope(toUnit * fromCenter);
}

UnitBallMap unitBallMap(const Placement& inBone, float reach, const glm::mat4& boneInWorld) {
  // In double, since a bone in meters under a parent scaled by 0.01 would lose visible digits.
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
    map.form = UnitForm::kSphere;  // Without rotation, which makes no difference to a sphere.
    map.inverseRadius = static_cast<float>(1.0 / radius);
    map.toUnit = glm::mat3(map.inverseRadius);
    map.boundingRadius = static_cast<float>(radius * (1.0 + kRound));
    map.meanRadius = static_cast<float>(radius);
    return map;
  }
  map.toUnit = glm::mat3(glm::inverse(axes));
  map.meanRadius = static_cast<float>(std::cbrt(std::abs(glm::determinant(axes))));
  map.meanRadius *= map.shape.meanRadius;
  const double around = ballAround(map.shape, axes);
  map.boundingRadius = static_cast<float>(around * (1.0 + 1e-6));
  return map;
}

glm::mat4 shapeInWorld(const Placement& inBone, float scale, const glm::mat4& boneInWorld) {
  const glm::mat4 moved = glm::translate(boneInWorld, inBone.center) * glm::mat4_cast(inBone.rotation);
  return glm::scale(moved, inBone.radii * scale);
}

Bounds boundsOf(std::span<const glm::vec3> points) {
  Bounds box;
  for (const glm::vec3& p : points) box.add(p);
  return box;
}

glm::vec3 normalizeOr(const glm::vec3& v, const glm::vec3& fallback) {
  const float squared = glm::dot(v, v);
  if (squared > 1e-20f && squared < 1e20f) return v / std::sqrt(squared);
  // Scales first, so that tiny and huge vectors do not lose their direction to under- or overflow.
  const float largest = std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z)));
  if (!(largest > std::numeric_limits<float>::min()) || !std::isfinite(largest)) return fallback;
  const glm::vec3 scaled = v / largest;
  return scaled / std::sqrt(glm::dot(scaled, scaled));
}

glm::mat3 normalMatrix(const glm::mat3& m) {
  const glm::mat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::dot(m[0], cofactors[0]) < 0.0f ? -1.0f * cofactors : cofactors;
}

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool isFinite(const glm::mat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(m[column][row])) return false;
    }
  }
  return true;
}

}  // namespace sinew
