// core/geometry/geometry.cpp: boxes, safe normalizing, the matrix of normals.
#include "sinew/geometry/geometry.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace sinew {

Bounds boundsOf(std::span<const glm::vec3> points) {
  Bounds box;
  for (const glm::vec3& p : points) box.add(p);
  return box;
}

glm::vec3 normalizeOr(const glm::vec3& v, const glm::vec3& fallback) {
  const float squared = glm::dot(v, v);
  if (squared > 1e-20f && squared < 1e20f) return v / std::sqrt(squared);
  // Scaled first, so that neither tiny nor huge vectors lose their direction to under- or overflow.
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
