// core/surface/finish/moved_triangles.h: the part of the mesh that muscles change in a pose.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// A vertex for vector code: x, y, z on the patch, 0, x, y, z on the surface, 0.
struct alignas(32) VertexPair {
  std::array<float, 8> of{};
};

/// Pairs of the vertices that a stage reads. Reused from pose to pose for its memory.
class VertexPairs {
 public:
  /// @param vertices  to be read.  @param patch, positions [V'] world.
  void fill(std::span<const int> vertices, std::span<const glm::vec3> patch, std::span<const glm::vec3> positions) {
    constexpr std::size_t kFew = 2048;  // For one thread.
    pairs_.resize(positions.size());
    forEachIndex(vertices.size(), kFew, [&](std::size_t i) {
      const glm::vec3& p = at(patch, vertices[i]);
      const glm::vec3& q = at(positions, vertices[i]);
      at(pairs_, vertices[i]).of = {p.x, p.y, p.z, 0.0f, q.x, q.y, q.z, 0.0f};
    });
  }

  void moveTo(int vertex, const glm::vec3& position) {
    std::array<float, 8>& of = at(pairs_, vertex).of;
    for (int i = 0; i < 3; ++i) at(of, 4 + i) = position[i];
  }

  [[nodiscard]] const VertexPair* data() const { return pairs_.data(); }

 private:
  std::vector<VertexPair> pairs_;  ///< [V']
};

/// The input of the stages after projection. Reused from pose to pose for its memory.
struct MovedTriangles {
  std::vector<std::uint8_t> isControl;  ///< [T] 1: the control triangle has a moved vertex.
  std::vector<int> refined;             ///< Refined triangles at vertices of `near`. Ascending.
  std::vector<std::uint8_t> isNear;     ///< [V'] 1: it or a neighbor has moved.
  std::vector<int> near;                ///< Vertices with isNear. Ascending.
  std::vector<int> corners;             ///< Vertices of `refined`, including `near`. Ascending.

  /// @param patch, positions [V'] world; a vertex has moved where they differ.
  void find(const Refinement& refinement, std::span<const glm::vec3> patch, std::span<const glm::vec3> positions);

 private:
  std::vector<std::uint8_t> isMoved_;   ///< [V']
  std::vector<std::uint8_t> isCorner_;  ///< [V'] corner of a triangle in `refined`.
};

}  // namespace sinew
