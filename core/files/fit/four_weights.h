// core/files/fit/four_weights.h: at most four weights a vertex, and where they put it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "sinew/character/pose.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew::exporting {

// The best weights of one vertex: at most four, >= 0, sum 1, least squares.

inline constexpr std::size_t kMostCandidates = 16;

/// Symmetric; rows and columns are candidates.
using Gram = std::array<std::array<double, kMostCandidates>, kMostCandidates>;
using CandidateWeights = std::array<double, kMostCandidates>;

/// w^T G w: the sum of squared distances, where G holds the products of the candidates' ways to the target.
[[nodiscard]] double energyOf(const Gram& gram, const CandidateWeights& weights, std::size_t count);

/// The least w^T G w + mu |w - near|^2 with w >= 0, sum 1 and at most four of them not 0: exact, for every choice of up
/// to four is tried, and the best weights are those of the choice whose own best has none below 0.
/// @param gram  positive semidefinite  @param count  candidates in use, 1..kMostCandidates  @param mu  > 0
[[nodiscard]] CandidateWeights bestWeights(const Gram& gram, std::size_t count, double mu,
                                           const CandidateWeights& near);

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
