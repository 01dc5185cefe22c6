// core/geometry/triangle_sides.h: lengths of the sides of triangles and of edges.
#pragma once

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "sinew/geometry/control_mesh.h"

namespace sinew {

/// Side i joins corners i and (i+1)%3.
[[nodiscard]] inline std::array<float, 3> sideLengths(const std::array<glm::vec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  return {glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)};
}

[[nodiscard]] inline float longestSide(const std::array<glm::vec3, 3>& corners) {
  return std::ranges::max(sideLengths(corners));
}

// In the bind pose:

[[nodiscard]] inline std::array<glm::vec3, 3> cornersOf(const ControlMesh& mesh, const ControlTriangle& triangle) {
  const auto& [a, b, c] = triangle.vertices;
  return {at(mesh.positions, a), at(mesh.positions, b), at(mesh.positions, c)};
}

[[nodiscard]] inline float lengthOf(const ControlMesh& mesh, const Edge& edge) {
  return glm::distance(at(mesh.positions, edge.vertices[0]), at(mesh.positions, edge.vertices[1]));
}

}  // namespace sinew
