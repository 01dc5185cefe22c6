// core/geometry/normals.cpp: angle-weighted vertex normals.
// Source: G. Thuermer, C. A. Wuethrich, "Computing vertex normals from polygonal facets", J. Graphics Tools 3(1), 1998.
#include "core/geometry/normals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/at.h"

namespace sinew {

// Volume of a matrix's columns against their lengths.

bool isFlat(const glm::dmat3& matrix) {
  constexpr double kFlat = 1e-6;
  const double lengths = glm::length(matrix[0]) * glm::length(matrix[1]) * glm::length(matrix[2]);
  const double volume = std::abs(glm::determinant(matrix));
  return !(volume > kFlat * lengths) || !std::isfinite(volume);
}

namespace {

/// Angle at `a` between the directions to b and c; 0 where one has no length.
double cornerAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = b - a;
  const glm::dvec3 v = c - a;
  // atan2 keeps its accuracy for slivers, where acos of the normalized dot product loses it.
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

glm::dvec3 pointOf(std::span<const glm::vec3> positions, int vertex) { return glm::dvec3(at(positions, vertex)); }

/// Lengths relative to the mesh: squares of very small or large coordinates would leave the range of numbers.
double scaleOf(std::span<const glm::vec3> positions) {
  const Bounds bounds = boundsOf(positions);
  const glm::dvec3 extent = bounds.isEmpty() ? glm::dvec3(1.0) : glm::dvec3(bounds.high) - glm::dvec3(bounds.low);
  const double largest = std::max({extent.x, extent.y, extent.z});
  return largest > 0.0 ? 1.0 / largest : 1.0;
}

/// The face's unit normal times each corner's angle, onto the sums of its vertices.
void addFace(std::span<const glm::vec3> positions, const ControlTriangle& triangle, double scale,
             std::vector<glm::dvec3>& sums) {
  std::array<glm::dvec3, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = scale * pointOf(positions, triangle.vertices[i]);
  const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double area = glm::length(cross);
  if (!(area > 0.0)) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = cornerAngle(p[i], p[(i + 1) % 3], p[(i + 2) % 3]);
    at(sums, triangle.vertices[i]) += (angle / area) * cross;
  }
}

glm::vec3 normalFrom(const glm::dvec3& sum) {
  // Faces that cancel leave rounding only; a true normal of one sliver still weighs far more than this.
  constexpr double kCanceled = 1e-10;
  const double length = glm::length(sum);
  return length > kCanceled ? glm::vec3(sum / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

}  // namespace

std::vector<glm::vec3> vertexNormals(std::span<const glm::vec3> positions, std::span<const ControlTriangle> triangles) {
  const double scale = scaleOf(positions);
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
  for (const ControlTriangle& triangle : triangles) addFace(positions, triangle, scale, sums);
  std::vector<glm::vec3> normals(positions.size());
  std::ranges::transform(sums, normals.begin(), normalFrom);
  return normals;
}

void updateVertexNormals(std::span<const glm::vec3> positions, std::span<const ControlTriangle> triangles,
                         const std::vector<bool>& asked, std::span<glm::vec3> normals) {
  const double scale = scaleOf(positions);
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
  for (const ControlTriangle& triangle : triangles) {
    const bool counts = std::ranges::any_of(triangle.vertices, [&](int v) { return asked[toIndex(v)]; });
    if (counts) addFace(positions, triangle, scale, sums);
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (asked[v]) normals[v] = normalFrom(sums[v]);
  }
}

}  // namespace sinew
