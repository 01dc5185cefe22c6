// core/surface/finish/vertex_rings.h: the neighbors and triangles of each refined vertex, and which lie on borders.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/at.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// [V'] 1: on an edge with a single triangle, where the surface is open.
[[nodiscard]] std::vector<std::uint8_t> borderVertices(const ControlMesh& mesh, const Refinement& refinement);

/// Neighbors, for means: each counts once per common triangle, so half along a border. Depends only on the refinement.
struct VertexRings {
  static constexpr std::size_t kMultiple = 6;  ///< Number of neighbors of nearly every vertex.

  std::vector<int> begin;         ///< [V' + 1] into `neighbors`; multiples of kMultiple.
  std::vector<int> neighbors;     ///< Ascending; once each if all share two triangles; padded with the vertex itself.
  std::vector<float> share;       ///< [V'] weight of one neighbor in the mean; 0 if there is none.
  std::vector<int> cornersBegin;  ///< [V' + 1] into `corners`.
  std::vector<int> corners;       ///< Triangle corners: 3 triangle + which of its corners is the vertex. Ascending.

  std::vector<int> acrossBegin;  ///< [V' + 1] into `across`; multiples of kMultiple.
  std::vector<int> across;       ///< Vertices opposite across an edge of two triangles. Padded likewise.

  std::vector<int> placeOf;  ///< [3 T n^2] place of each corner in `corners`.

  // The first two have multiples of kMultiple, which may include the vertex itself.
  [[nodiscard]] std::span<const int> at(int vertex) const { return of(neighbors, begin, vertex); }
  [[nodiscard]] std::span<const int> acrossFrom(int vertex) const { return of(across, acrossBegin, vertex); }
  [[nodiscard]] std::span<const int> cornersOf(int vertex) const { return of(corners, cornersBegin, vertex); }

 private:
  [[nodiscard]] static std::span<const int> of(const std::vector<int>& list, const std::vector<int>& begin,
                                               int vertex) {
    const int first = sinew::at(begin, vertex);
    return std::span(list).subspan(toIndex(first), toIndex(sinew::at(begin, vertex + 1) - first));
  }
};

[[nodiscard]] VertexRings vertexRings(const Refinement& refinement);

}  // namespace sinew
