// core/surface/finish/vertex_rings.h: the neighbors of each refined vertex, those across, and the triangles at it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

// Where the surface is open.

/// [V'] 1: on an edge with a single triangle. (Where more than two meet they share their vertices: nothing can open.)
[[nodiscard]] std::vector<std::uint8_t> borderVertices(const ControlMesh& mesh, const Refinement& refinement);

/// Means over neighbors: each counts once for every triangle shared, so that along a border they count half. Depends
/// on the refinement alone.
struct VertexRings {
  static constexpr std::size_t kMultiple = 6;  ///< What nearly every vertex has.

  std::vector<int> begin;         ///< [V' + 1] into `neighbors`; multiples of kMultiple.
  std::vector<int> neighbors;     ///< Ascending; once where all share two triangles; filled up with the vertex itself.
  std::vector<float> share;       ///< [V'] of one neighbor in the mean; 0 where there is none.
  std::vector<int> cornersBegin;  ///< [V' + 1] into `corners`.
  std::vector<int> corners;       ///< Triangle corners: 3 triangle + which of its corners is the vertex. Ascending.

  std::vector<int> acrossBegin;  ///< [V' + 1] into `across`; multiples of kMultiple.
  std::vector<int> across;  ///< Vertices across an edge: an edge's two triangles hold one each. Filled up likewise.

  std::vector<int> placeOf;  ///< [3 T n^2] of each corner, its place in `corners`.

  /// As many as a multiple of kMultiple; the vertex itself may be among them.
  [[nodiscard]] std::span<const int> at(int vertex) const { return of(neighbors, begin, vertex); }
  /// Likewise.
  [[nodiscard]] std::span<const int> acrossFrom(int vertex) const { return of(across, acrossBegin, vertex); }
  [[nodiscard]] std::span<const int> cornersOf(int vertex) const { return of(corners, cornersBegin, vertex); }

 private:
  [[nodiscard]] static std::span<const int> of(const std::vector<int>& list, const std::vector<int>& begin,
                                               int vertex) {
    const auto v = static_cast<std::size_t>(vertex);
    return std::span(list).subspan(static_cast<std::size_t>(begin[v]),
                                   static_cast<std::size_t>(begin[v + 1] - begin[v]));
  }
};

[[nodiscard]] VertexRings vertexRings(const Refinement& refinement);

}  // namespace sinew
