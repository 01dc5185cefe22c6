// tests/support/surface/eyes.h: viewpoints all around.
#pragma once

#include <cmath>
#include <vector>

#include "sinew/geometry/geometry.h"

namespace sinew::test {

/// Unit vectors distributed evenly over the sphere by the golden angle.
inline std::vector<glm::vec3> spreadDirections(int count) {
  std::vector<glm::vec3> directions;
  for (int i = 0; i < count; ++i) {
    const float y = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(count);
    const float angle = 2.3999632f * static_cast<float>(i);
    const float ring = std::sqrt(1.0f - y * y);
    directions.emplace_back(ring * std::cos(angle), y, ring * std::sin(angle));
  }
  return directions;
}

/// For every direction one near eye, one far eye and one practically without perspective.
inline std::vector<glm::vec3> eyesAround(const Bounds& bounds, int directions) {
  std::vector<glm::vec3> eyes;
  const float radius = 0.5f * glm::length(bounds.high - bounds.low);
  for (const glm::vec3& direction : spreadDirections(directions)) {
    for (const float distance : {1.3f, 8.0f, 1e6f}) eyes.push_back(bounds.center() + direction * (distance * radius));
  }
  return eyes;
}

}  // namespace sinew::test
