// tests/support/oracle_rise.cpp: twelve rounds over all edges, each from the round before alone.

#include "tests/support/oracle_rise.h"

#include <algorithm>

namespace sinew::oracle {
namespace {

constexpr int kRounds = 12;

/// A unit vector at most 60 degrees from a unit normal: turned towards it in the plane of the two.
Vec limited(const Vec& direction, const Vec& normal) {
  const double cosine = dot(direction, normal);
  if (cosine >= 0.5) return direction;
  const Vec across = unitOr(direction - cosine * normal, normal);
  return unitOr(0.5 * normal + std::sqrt(0.75) * across, normal);
}

}  // namespace

std::vector<Vec> relaxedDirections(const ControlMesh& mesh, double rise) {
  std::vector<Vec> normals;
  for (const glm::vec3& normal : mesh.normals) normals.push_back(vec(normal));
  std::vector<Vec> directions = normals;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Vec> sums = directions;
    for (const Edge& edge : mesh.edges) {
      const auto a = static_cast<std::size_t>(edge.vertices[0]);
      const auto b = static_cast<std::size_t>(edge.vertices[1]);
      const Vec along = vec(mesh.positions[b]) - vec(mesh.positions[a]);
      const double squared = dot(along, along);
      if (squared == 0.0) continue;
      const double weight = std::max(0.0, -rise * dot(directions[b] - directions[a], along) / squared);
      sums[a] = sums[a] + weight * directions[b];
      sums[b] = sums[b] + weight * directions[a];
    }
    for (std::size_t v = 0; v < sums.size(); ++v) directions[v] = limited(unitOr(sums[v], normals[v]), normals[v]);
  }
  return directions;
}

}  // namespace sinew::oracle
