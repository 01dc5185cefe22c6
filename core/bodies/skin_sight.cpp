// core/bodies/skin_sight.cpp: rays in directions that are spread evenly.
#include "core/bodies/skin_sight.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "sinew/geometry/geometry.h"

namespace sinew {
namespace {

constexpr std::size_t kDirections = 256;

/// A spiral with the golden angle between one and the next.
std::array<glm::vec3, kDirections> spreadDirections() {
  std::array<glm::vec3, kDirections> out;
  const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (std::size_t i = 0; i < kDirections; ++i) {
    const double y = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(kDirections);
    const double radius = std::sqrt(1.0 - y * y);
    const double angle = turn * static_cast<double>(i);
    out[i] = glm::vec3(glm::dvec3(radius * std::cos(angle), y, radius * std::sin(angle)));
  }
  return out;
}

}  // namespace

bool isSeen(const TriangleTree& triangles, const glm::vec3& place, const glm::vec3& normal, float off) {
  static const std::array<glm::vec3, kDirections> kAround = spreadDirections();
  const glm::vec3 unit = normalizeOr(normal, glm::vec3(0.0f));
  const glm::vec3 from = place + off * unit;
  for (const glm::vec3& direction : kAround) {
    if (glm::dot(direction, unit) > 0.0f && !triangles.isMetBy(from, direction)) return true;
  }
  return false;
}

}  // namespace sinew
