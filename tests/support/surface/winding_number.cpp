// tests/support/surface/winding_number.cpp: the solid angles of all triangles, in doubles.
#include "tests/support/surface/winding_number.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace sinew::test {

double windingNumber(const ControlMesh& mesh, const glm::dvec3& point) {
  double sum = 0.0;
  for (const ControlTriangle& triangle : mesh.triangles) {
    std::array<glm::dvec3, 3> r;
    for (std::size_t k = 0; k < 3; ++k) {
      r[k] = glm::dvec3(mesh.positions[static_cast<std::size_t>(triangle.vertices[k])]) - point;
    }
    const double a = glm::length(r[0]);
    const double b = glm::length(r[1]);
    const double c = glm::length(r[2]);
    const double over = glm::dot(r[0], glm::cross(r[1], r[2]));
    const double under = a * b * c + glm::dot(r[0], r[1]) * c + glm::dot(r[1], r[2]) * a + glm::dot(r[2], r[0]) * b;
    sum += 2.0 * std::atan2(over, under);
  }
  return sum / (4.0 * std::numbers::pi);
}

}  // namespace sinew::test
