// core/files/export/into_mesh.h: from the bind pose into the space that a file's vertices are in.
#pragma once

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/files/gltf/node_tree.h"
#include "sinew/geometry/geometry.h"

namespace sinew::exporting {

/// World in the bind pose -> a skin's mesh space.
struct IntoMesh {
  explicit IntoMesh(const glm::dmat4& meshToBind)
      : inverse(gltf::affineInverse(meshToBind).value_or(glm::dmat4(1.0))), linear(glm::dmat3(meshToBind)) {}

  [[nodiscard]] glm::vec3 point(const glm::vec3& p) const {
    return glm::vec3(inverse * glm::dvec4(glm::dvec3(p), 1.0));
  }
  [[nodiscard]] glm::dvec3 way(const glm::dvec3& d) const { return glm::dmat3(inverse) * d; }
  [[nodiscard]] glm::vec3 normal(const glm::vec3& n) const {
    return normalizeOr(glm::vec3(glm::normalize(glm::transpose(linear) * glm::dvec3(n))), n);
  }
  [[nodiscard]] bool mirrors() const { return glm::determinant(linear) < 0.0; }

  glm::dmat4 inverse;
  glm::dmat3 linear;
};

}  // namespace sinew::exporting
