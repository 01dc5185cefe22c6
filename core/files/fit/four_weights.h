// core/files/fit/four_weights.h: at most four weights a vertex, and where they put it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "sinew/character/pose.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew::exporting {

inline constexpr int kMostWeights = 4;  ///< A vertex, in every engine.

/// Weights of one vertex, the largest first, > 0, sum 1 to the last bit but one; unused ones are 0 on binding -1.
/// Bindings of the skeleton are followed by joints that the export adds, in order (helper_joint.h).
struct FourWeights {
  std::array<int, kMostWeights> binding{-1, -1, -1, -1};
  std::array<float, kMostWeights> weight{};

  friend bool operator==(const FourWeights&, const FourWeights&) = default;
};

/// One binding's share in the making.
struct Share {
  int binding = 0;
  double weight = 0.0;
};

/// The four largest (of equals the lower binding), scaled to sum 1.
/// @param shares  each binding once; some weight > 0
[[nodiscard]] FourWeights fourLargest(std::vector<Share> shares);

/// What every refined vertex follows: the weights of its control triangle's corners, barycentric. Sorted by binding.
[[nodiscard]] std::vector<std::vector<Share>> interpolatedWeights(const ControlMesh& mesh,
                                                                  const Refinement& refinement);

/// From the bind pose to a pose, one for each binding.
void bindingMatrices(const Skeleton& skeleton, const Pose& pose, std::vector<glm::dmat4>& out);

/// The matrix times (x, y, z, 1), but for the last row. Inline, where glm's product is a call.
[[nodiscard]] inline glm::dvec3 carryPoint(const glm::dmat4& matrix, const glm::dvec3& point) {
  return (glm::dvec3(matrix[0]) * point.x + glm::dvec3(matrix[1]) * point.y) +
         (glm::dvec3(matrix[2]) * point.z + glm::dvec3(matrix[3]));
}

/// Linear blend skinning of a point of the bind pose.
[[nodiscard]] glm::dvec3 skinPoint(std::span<const glm::dmat4> matrices, const FourWeights& weights,
                                   const glm::dvec3& point);

}  // namespace sinew::exporting
