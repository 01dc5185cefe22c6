// core/surface/finish/refined_corners.h: a refined triangle by its corners.
#pragma once

#include <array>
#include <span>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/triangle_tree.h"
#include "sinew/geometry/geometry.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// @param of  [V'] positions, or normals
[[nodiscard]] inline TriangleCorners refinedCorners(const Refinement& refinement, int triangle,
                                                    std::span<const glm::vec3> of) {
  const std::array<int, 3>& t = at(refinement.triangles, triangle);
  return {at(of, t[0]), at(of, t[1]), at(of, t[2])};
}

/// Unit normal; 0 of a triangle without area.
[[nodiscard]] inline glm::vec3 faceOf(const TriangleCorners& c) {
  return normalizeOr(glm::cross(c[1] - c[0], c[2] - c[0]), glm::vec3(0.0f));
}

}  // namespace sinew
