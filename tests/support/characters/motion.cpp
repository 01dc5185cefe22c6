// tests/support/characters/motion.cpp: offsets in frames that move with the patch.

#include "tests/support/characters/motion.h"

#include <glm/geometric.hpp>

#include "sinew/geometry/geometry.h"

namespace sinew::test {

CarriedOffsets::CarriedOffsets(const Refinement& refinement)
    : neighbor_(static_cast<std::size_t>(refinement.vertexCount), 0) {
  for (const auto& t : refinement.triangles) {
    for (std::size_t i = 0; i < 3; ++i) neighbor_[static_cast<std::size_t>(t[i])] = t[(i + 1) % 3];
  }
}

PatchFrame CarriedOffsets::frame(const Surface& patch, int vertex) const {
  const auto v = static_cast<std::size_t>(vertex);
  const glm::vec3 n = patch.normals[v];
  const glm::vec3 towards = patch.positions[static_cast<std::size_t>(neighbor_[v])] - patch.positions[v];
  const glm::vec3 tangent = normalizeOr(towards - glm::dot(towards, n) * n, {1.0f, 0.0f, 0.0f});
  return {patch.positions[v], glm::mat3(n, tangent, glm::cross(n, tangent))};
}

std::vector<glm::vec3> CarriedOffsets::of(const Surface& surface, const Surface& patch) const {
  std::vector<glm::vec3> out(surface.positions.size(), glm::vec3(0.0f));
  for (std::size_t v = 0; v < out.size(); ++v) {
    if (surface.positions[v] == patch.positions[v]) continue;  // No frame needed: most of the skin.
    out[v] = frame(patch, static_cast<int>(v)).seen(surface.positions[v]);
  }
  return out;
}

}  // namespace sinew::test
