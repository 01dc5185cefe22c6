// core/mesh/normals.cpp: angle-weighted vertex normals.
// Source: G. Thuermer, C. A. Wuethrich, "Computing vertex normals from polygonal facets", J. Graphics Tools 3(1), 1998.

#include "core/mesh/normals.h"

#include <algorithm>
#include <cmath>

#include "core/base/at.h"

namespace sinew {
namespace {

/// Angle at `a` between the directions to b and c; 0 where one has no length.
double cornerAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = b - a;
  const glm::dvec3 v = c - a;
  // atan2 keeps its accuracy for slivers, where acos of the normalized dot product loses it.
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

glm::dvec3 pointOf(std::span<const glm::vec3> positions, int vertex) { return glm::dvec3(at(positions, vertex)); }

}  // namespace

std::vector<glm::vec3> vertexNormals(std::span<const glm::vec3> positions, std::span<const ControlTriangle> triangles) {
  // Lengths relative to the mesh: squares of very small or large coordinates would leave the range of numbers.
  const Bounds bounds = boundsOf(positions);
  const glm::dvec3 extent = bounds.isEmpty() ? glm::dvec3(1.0) : glm::dvec3(bounds.high) - glm::dvec3(bounds.low);
  const double largest = std::max({extent.x, extent.y, extent.z});
  const double scale = largest > 0.0 ? 1.0 / largest : 1.0;

  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
  for (const ControlTriangle& triangle : triangles) {
    std::array<glm::dvec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = scale * pointOf(positions, triangle.vertices[i]);
    const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double area = glm::length(cross);
    if (!(area > 0.0)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle = cornerAngle(p[i], p[(i + 1) % 3], p[(i + 2) % 3]);
      at(sums, triangle.vertices[i]) += (angle / area) * cross;
    }
  }

  // Faces that cancel leave rounding only; a true normal of one sliver still weighs far more than this.
  constexpr double kCanceled = 1e-10;
  std::vector<glm::vec3> normals(positions.size(), glm::vec3(0.0f, 1.0f, 0.0f));
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double length = glm::length(sums[v]);
    if (length > kCanceled) normals[v] = glm::vec3(sums[v] / length);
  }
  return normals;
}

}  // namespace sinew
