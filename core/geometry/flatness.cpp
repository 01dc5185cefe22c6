// core/geometry/flatness.cpp: volume of a matrix's columns against their lengths.
#include "core/geometry/flatness.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace sinew {

bool isFlat(const glm::dmat3& matrix) {
  constexpr double kFlat = 1e-6;
  const double lengths = glm::length(matrix[0]) * glm::length(matrix[1]) * glm::length(matrix[2]);
  const double volume = std::abs(glm::determinant(matrix));
  return !(volume > kFlat * lengths) || !std::isfinite(volume);
}

}  // namespace sinew
