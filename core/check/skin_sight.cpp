// core/check/skin_sight.cpp: rays in directions that are spread evenly.
#include "core/check/skin_sight.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/at.h"

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

TriangleTree treeOfAll(const Surface& surface) {
  std::vector<TriangleCorners> corners;
  std::vector<int> numbers;
  for (const std::array<int, 3>& t : surface.refinement->triangles) {
    corners.push_back({at(surface.positions, t[0]), at(surface.positions, t[1]), at(surface.positions, t[2])});
    numbers.push_back(static_cast<int>(numbers.size()));
  }
  return {corners, numbers};
}

}  // namespace

SkinSight::SkinSight(const Surface& surface) : tree_(treeOfAll(surface)) {}

bool SkinSight::isSeen(const glm::vec3& place, const glm::vec3& normal, float off) const {
  static const std::array<glm::vec3, kDirections> kAround = spreadDirections();
  const glm::vec3 unit = normalizeOr(normal, glm::vec3(0.0f));
  const glm::vec3 from = place + off * unit;
  for (const glm::vec3& direction : kAround) {
    if (glm::dot(direction, unit) > 0.0f && !tree_.isMetBy(from, direction)) return true;
  }
  return false;
}

}  // namespace sinew
