// core/surface/projection/rise_directions.cpp: normals relaxed over the edges along which they converge.
#include "core/surface/projection/rise_directions.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace sinew {
namespace {

constexpr int kRounds = 24;
constexpr float kNearestWide = 0.5f;  ///< Cosine of the widest angle between a direction and its normal.

/// How strongly an edge asks for its ends to agree: rise over the height at which lifted ends would meet. 0 where the
/// directions diverge.
float convergence(const glm::vec3& edge, const glm::vec3& a, const glm::vec3& b, float rise) {
  const float squared = glm::dot(edge, edge);
  if (!(squared > 0.0f)) return 0.0f;
  return std::max(0.0f, -rise * glm::dot(b - a, edge) / squared);
}

/// The direction nearest to `wanted` that is within the widest angle of the normal.
glm::vec3 nearNormal(const glm::vec3& wanted, const glm::vec3& normal) {
  const float along = glm::dot(wanted, normal);
  if (along >= kNearestWide) return wanted;
  const glm::vec3 sideways = normalizeOr(wanted - along * normal, glm::vec3(0.0f));
  return normalizeOr(kNearestWide * normal + std::sqrt(1.0f - kNearestWide * kNearestWide) * sideways, normal);
}

}  // namespace

std::vector<glm::vec3> riseDirections(const ControlMesh& mesh, float rise) {
  std::vector<glm::vec3> directions = mesh.normals;
  std::vector<glm::vec3> sums(directions.size());
  std::vector<float> weights(directions.size());
  for (int round = 0; round < kRounds; ++round) {
    std::ranges::fill(sums, glm::vec3(0.0f));
    std::ranges::fill(weights, 0.0f);
    for (const Edge& edge : mesh.edges) {
      const auto a = static_cast<std::size_t>(edge.vertices[0]);
      const auto b = static_cast<std::size_t>(edge.vertices[1]);
      const float weight = convergence(mesh.positions[b] - mesh.positions[a], directions[a], directions[b], rise);
      sums[a] += weight * directions[b];
      sums[b] += weight * directions[a];
      weights[a] += weight;
      weights[b] += weight;
    }
    for (std::size_t v = 0; v < directions.size(); ++v) {
      if (weights[v] == 0.0f) continue;
      // At least half is the direction's own: on dense meshes neighbors weigh so much that they would trade places,
      // round after round.
      directions[v] =
          nearNormal(normalizeOr((1.0f + weights[v]) * directions[v] + sums[v], mesh.normals[v]), mesh.normals[v]);
    }
  }
  return directions;
}

}  // namespace sinew
