// core/surface/finish/vertex_pairs.h: vertices on their patch and on the surface, as vector code reads triangles.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"

namespace sinew {

/// x, y, z on the patch, 0, x, y, z on the surface, 0.
struct alignas(32) VertexPair {
  std::array<float, 8> of{};
};

/// Pairs of the vertices that a stage reads. Kept from pose to pose for its memory.
class VertexPairs {
 public:
  /// @param vertices  those that will be read.  @param patch, positions [V'] world.
  void fill(std::span<const int> vertices, std::span<const glm::vec3> patch, std::span<const glm::vec3> positions) {
    constexpr std::size_t kFew = 2048;  // For one thread.
    pairs_.resize(positions.size());
    forEachIndex(vertices.size(), kFew, [&](std::size_t i) {
      const glm::vec3& p = at(patch, vertices[i]);
      const glm::vec3& q = at(positions, vertices[i]);
      at(pairs_, vertices[i]).of = {p.x, p.y, p.z, 0.0f, q.x, q.y, q.z, 0.0f};
    });
  }

  /// A filled vertex has moved on.
  void moveTo(int vertex, const glm::vec3& position) {
    std::array<float, 8>& of = at(pairs_, vertex).of;
    for (int i = 0; i < 3; ++i) at(of, 4 + i) = position[i];
  }

  [[nodiscard]] const VertexPair* data() const { return pairs_.data(); }

 private:
  std::vector<VertexPair> pairs_;  ///< [V']
};

}  // namespace sinew
