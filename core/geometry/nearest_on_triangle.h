// core/geometry/nearest_on_triangle.h: the point of a triangle that is nearest to another point.
#pragma once

#include <array>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace sinew {

using TriangleCorners = std::array<glm::vec3, 3>;

/// The point with these barycentric coordinates.
[[nodiscard]] inline glm::vec3 mixed(const TriangleCorners& c, const glm::vec3& shares) {
  return shares.x * c[0] + shares.y * c[1] + shares.z * c[2];
}

/// Barycentric coordinates of the triangle's point nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
/// Exactly 0 for corners that the point does not need.
[[nodiscard]] inline glm::vec3 nearestOnTriangle(const glm::vec3& p, const TriangleCorners& c) {
  const glm::vec3 ab = c[1] - c[0];
  const glm::vec3 ac = c[2] - c[0];
  const glm::vec3 ap = p - c[0];
  const float a1 = glm::dot(ab, ap);
  const float a2 = glm::dot(ac, ap);
  if (a1 <= 0.0f && a2 <= 0.0f) return {1.0f, 0.0f, 0.0f};
  const glm::vec3 bp = p - c[1];
  const float b1 = glm::dot(ab, bp);
  const float b2 = glm::dot(ac, bp);
  if (b1 >= 0.0f && b2 <= b1) return {0.0f, 1.0f, 0.0f};
  const float vc = a1 * b2 - b1 * a2;
  if (vc <= 0.0f && a1 >= 0.0f && b1 <= 0.0f) {
    const float t = a1 / (a1 - b1);
    return {1.0f - t, t, 0.0f};
  }
  const glm::vec3 cp = p - c[2];
  const float c1 = glm::dot(ab, cp);
  const float c2 = glm::dot(ac, cp);
  if (c2 >= 0.0f && c1 <= c2) return {0.0f, 0.0f, 1.0f};
  const float vb = c1 * a2 - a1 * c2;
  if (vb <= 0.0f && a2 >= 0.0f && c2 <= 0.0f) {
    const float t = a2 / (a2 - c2);
    return {1.0f - t, 0.0f, t};
  }
  const float va = b1 * c2 - c1 * b2;
  if (va <= 0.0f && b2 - b1 >= 0.0f && c1 - c2 >= 0.0f) {
    const float t = (b2 - b1) / ((b2 - b1) + (c1 - c2));
    return {0.0f, 1.0f - t, t};
  }
  const float all = va + vb + vc;
  return all > 0.0f ? glm::vec3(va / all, vb / all, vc / all) : glm::vec3(1.0f, 0.0f, 0.0f);
}

}  // namespace sinew
