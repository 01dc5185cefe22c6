// core/files/fit/trs.cpp: to matrices and back.
#include "core/files/fit/trs.h"

#include <glm/geometric.hpp>

namespace sinew::exporting {

glm::dmat4 Trs::toMatrix() const {
  const glm::dmat3 turn = glm::mat3_cast(rotation);
  return {glm::dvec4(scale.x * turn[0], 0.0), glm::dvec4(scale.y * turn[1], 0.0), glm::dvec4(scale.z * turn[2], 0.0),
          glm::dvec4(translation, 1.0)};
}

Trs trsOf(const glm::dmat4& matrix) {
  Trs result;
  result.translation = glm::dvec3(matrix[3]);
  const glm::dvec3 x(matrix[0]);
  const glm::dvec3 y(matrix[1]);
  const glm::dvec3 z(matrix[2]);
  result.scale = {glm::length(x), glm::length(y), glm::length(z)};
  const glm::dvec3 across = glm::cross(x, y);
  if (!(glm::length(across) > 0.0) || !(result.scale.z > 0.0)) {
    result.scale = glm::dvec3(0.0);
    return result;
  }
  const glm::dvec3 along = y / result.scale.y;
  const glm::dvec3 up = glm::normalize(across);
  result.rotation = glm::normalize(glm::quat_cast(glm::dmat3(glm::cross(along, up), along, up)));
  return result;
}

Trs roundToFloats(const Trs& exact) {
  const glm::quat turn(exact.rotation);
  return {glm::dvec3(glm::vec3(exact.translation)), glm::normalize(glm::dquat(turn)),
          glm::dvec3(glm::vec3(exact.scale))};
}

}  // namespace sinew::exporting
