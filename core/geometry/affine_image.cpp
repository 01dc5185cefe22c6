// core/geometry/affine_image.cpp: principal axes by Jacobi; a canonical rotation for reflections.
#include "core/geometry/affine_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace sinew {
namespace {

constexpr double kEven = 1e-6;     // Relative tolerance of lengths and angles: below the precision of floats in a file.
constexpr int kJacobiSweeps = 40;  // At most about eight are needed.

/// Rotation under an improper orthogonal map, which decides whether one or all axes are negated, as its inverse does.
glm::dquat properRotation(const glm::dmat3& linear, const glm::dquat& rotation) {
  // p = -linear as a rotation: near the unit quaternion all three are negated, near i, j or k that axis.
  const glm::dquat p = glm::normalize(glm::quat_cast(-linear));
  const std::array<double, 4> parts{p.w, p.x, p.y, p.z};
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (std::abs(parts[i]) > std::abs(parts[largest]) + 1e-3) largest = i;
  }
  glm::dquat turned(0.0, 0.0, 0.0, 0.0);
  (largest == 0 ? turned.w : (largest == 1 ? turned.x : (largest == 2 ? turned.y : turned.z))) = 1.0;
  glm::dquat image = p * rotation * turned;
  // The identity's image has w > 0, so that the inverse undoes the sign as well.
  const double identityW = (p * turned).w;
  return identityW < 0.0 ? -image : image;
}

/// Cyclic one-sided Jacobi: rotates the columns until they are perpendicular.
void orthogonalise(glm::dmat3& columns) {
  for (int sweep = 0; sweep < kJacobiSweeps; ++sweep) {
    bool still = true;
    for (const auto& [a, b] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      const glm::dvec3 u = columns[a];
      const glm::dvec3 v = columns[b];
      const double inner = glm::dot(u, v);
      if (std::abs(inner) <= (sweep == 0 ? kEven : 1e-14) * glm::length(u) * glm::length(v)) continue;
      still = false;
      const double zeta = (glm::dot(v, v) - glm::dot(u, u)) / (2.0 * inner);
      const double t = std::copysign(1.0, zeta) / (std::abs(zeta) + std::sqrt(1.0 + zeta * zeta));
      const double c = 1.0 / std::sqrt(1.0 + t * t);
      columns[a] = c * (u - t * v);
      columns[b] = c * (v + t * u);
    }
    if (still) return;
  }
}

/// The scale of a map that is a rotation or reflection with uniform scale, up to kEven.
std::optional<double> evenScale(const glm::dmat3& m) {
  const double scale = std::cbrt(std::abs(glm::determinant(m)));
  for (int i = 0; i < 3; ++i) {
    if (std::abs(glm::length(m[i]) / scale - 1.0) > kEven) return std::nullopt;
    if (std::abs(glm::dot(m[i], m[(i + 1) % 3])) > kEven * scale * scale) return std::nullopt;
  }
  return std::abs(scale - 1.0) <= kEven ? 1.0 : scale;
}

/// Keeps y and makes the other columns perpendicular to it and to each other.
void orthogonaliseAround(glm::dmat3& columns) {
  const glm::dvec3 along = glm::normalize(columns[1]);
  glm::dmat3 across = columns;
  for (const int i : {0, 2}) across[i] -= along * glm::dot(along, across[i]);
  across[1] = along * glm::length(across[0]);  // Perpendicular already, so it stays.
  orthogonalise(across);
  columns[0] = across[0];
  columns[2] = across[2];
}

/// The shape of the image, whose rotation and radii are known. Numbers along an axis change sign with it; under
/// non-uniform scale those across are components of a vector that is mapped.
Shape shapeImage(const Placement& from, const glm::dmat3& linear, bool even, const Placement& image) {
  Shape shape = from.shape;
  if (shape.isPlain()) return shape;
  const glm::dmat3 axes = linear * glm::mat3_cast(glm::normalize(glm::dquat(from.rotation)));
  const glm::dmat3 imageAxes = glm::mat3_cast(glm::normalize(glm::dquat(image.rotation)));
  for (const std::span<const ShapeNumber> key : shapeKeys()) {
    if (key.front().axis == ShapeNumber::kNoAxis) continue;
    glm::dvec3 vector(0.0);
    for (const ShapeNumber& number : key) {
      vector += axes[number.axis] * static_cast<double>(number.of(from.shape) * from.radii[number.axis]);
    }
    for (const ShapeNumber& number : key) {
      const glm::dvec3& own = imageAxes[number.axis];
      float& value = number.member(shape);
      if (even || number.axis == 1) {
        if (glm::dot(axes[number.axis], own) < 0.0) value = -value;
      } else {
        const double inRadii = glm::dot(vector, own) / static_cast<double>(image.radii[number.axis]);
        value = std::clamp(static_cast<float>(inRadii), number.low, number.high);
      }
    }
  }
  return shape;
}

/// For any affine map: the principal axes of the image, each nearest to the image of the same axis.
void placeByAxes(const Placement& from, const glm::dmat3& linear, Placement& image) {
  const glm::dmat3 axes = linear * glm::mat3_cast(glm::normalize(glm::dquat(from.rotation)));
  glm::dmat3 columns;
  for (int i = 0; i < 3; ++i) columns[i] = axes[i] * static_cast<double>(from.radii[i]);
  from.shape.isPlain() ? orthogonalise(columns) : orthogonaliseAround(columns);
  glm::dmat3 unit;
  for (int i = 0; i < 3; ++i) {
    const double length = glm::length(columns[i]);
    unit[i] = columns[i] / length;
    image.radii[i] = static_cast<float>(length);
  }
  if (!(glm::determinant(unit) < 0.0)) {
    image.rotation = glm::quat(glm::normalize(glm::quat_cast(unit)));
    return;
  }
  const glm::dmat3 start = glm::mat3_cast(glm::normalize(glm::dquat(from.rotation)));
  image.rotation = glm::quat(
      glm::normalize(properRotation(unit * glm::transpose(start), glm::normalize(glm::dquat(from.rotation)))));
}

}  // namespace

Placement imageOf(const Placement& placement, const AffineMap& map) {
  Placement image;
  image.center = glm::vec3(map.linear * glm::dvec3(placement.center) + map.offset);
  image.radii = placement.radii;
  const std::optional<double> scale = evenScale(map.linear);
  if (!scale) {
    placeByAxes(placement, map.linear, image);
    image.shape = shapeImage(placement, map.linear, false, image);
    return image;
  }
  if (*scale != 1.0) image.radii = glm::vec3(glm::dvec3(placement.radii) * *scale);
  const glm::dquat rotation(placement.rotation);
  const glm::dmat3 turn = map.linear / *scale;
  image.rotation = glm::quat(glm::determinant(turn) < 0.0 ? properRotation(turn, rotation)
                                                          : glm::normalize(glm::quat_cast(turn)) * rotation);
  image.shape = shapeImage(placement, turn, true, image);
  return image;
}

Placement withLongAxisY(const Placement& placement) {
  const glm::vec3& r = placement.radii;
  if (!placement.shape.isPlain()) return placement;
  if (r.y >= r.x && r.y >= r.z) return placement;
  Placement turned = placement;
  const float side = r.x >= r.z ? -0.5f : 0.5f;  // A third of a turn about (1, 1, 1), either way.
  turned.rotation = glm::normalize(placement.rotation * glm::quat(0.5f, side, side, side));
  turned.radii = side < 0.0f ? glm::vec3(r.z, r.x, r.y) : glm::vec3(r.y, r.z, r.x);
  return turned;
}

}  // namespace sinew
