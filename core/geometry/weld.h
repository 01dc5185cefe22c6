// core/geometry/weld.h: welds the split vertices of a file to geometric vertices and wedges; finds edges and borders.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/geometry/control_mesh.h"

namespace sinew {

/// Fills the mesh's edges, in order of first use, and those of its triangles, from the triangles' vertices.
void findEdges(ControlMesh& mesh);

/// Counts over a list of triangles with welded vertices.
struct Topology {
  int vertices = 0;  ///< Used by at least one triangle.
  int edges = 0;     ///< Distinct.
  int triangles = 0;
  std::vector<std::array<int, 2>> borderEdges;       ///< Of one triangle; smaller vertex first, sorted.
  std::vector<std::array<int, 2>> nonManifoldEdges;  ///< Of more than two triangles; smaller vertex first, sorted.

  /// Every edge has exactly two triangles.
  [[nodiscard]] bool closed() const { return triangles > 0 && borderEdges.empty() && nonManifoldEdges.empty(); }
};

[[nodiscard]] Topology topologyOf(std::span<const std::array<int, 3>> triangles);
[[nodiscard]] Topology topologyOf(const ControlMesh& mesh);

/// Largest rounding errors of vertices that a file rounds together; vertices of different pieces may differ by these.
struct RoundedPiece {
  float place = 0.0f;
  float weight = 0.0f;
};

/// Vertices and triangles as split in the file, at uv, normal and material seams. [N] vertices.
struct TriangleSoup {
  std::vector<glm::vec3> positions;   ///< [N] bind pose, world space; finite.
  std::vector<glm::vec2> uvs;         ///< [N] finite.
  std::vector<glm::vec4> colors;      ///< [N] linear RGBA, 0..1; or empty: white.
  std::vector<int> influenceBegin;    ///< [N+1]
  std::vector<Influence> influences;  ///< Sorted by binding within a vertex, each binding once, weights > 0, sum 1.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Indices < N, counter-clockwise from outside.
  std::vector<int> materials;                           ///< [triangles]
  std::vector<int> parts;                               ///< [triangles] or empty: all 0.
  std::vector<RoundedPiece> pieces;                     ///< Empty: nothing was rounded.
  std::vector<int> pieceOf;                             ///< [N] if there are pieces.
};

/// Merges vertices within `tolerance` (1e-6 of the height) of each other, with the same bindings and weights (to 1e-4),
/// to geometric vertices; vertices of different pieces also within their rounding errors. Vertices equal in uv and
/// color too become one wedge. Drops and counts triangles that lose a corner; slivers with three corners stay, since a
/// closed mesh needs them. Drops unused vertices. Also fills edges and normals. Deterministic order. docs/design.md.
/// @param standsFor  filled if not null: [V] soup vertex of each geometric vertex.
[[nodiscard]] ControlMesh weld(const TriangleSoup& soup, float tolerance, std::vector<int>* standsFor = nullptr);

/// [soup triangles] Triangle in the welded mesh, with the same order of corners; -1: dropped.
[[nodiscard]] std::vector<int> weldedTriangles(const TriangleSoup& soup, float tolerance);

/// Merges vertices by position alone, to show where separate parts touch. No influences, texture coordinates, colors.
[[nodiscard]] ControlMesh joinedByPosition(const ControlMesh& mesh, float tolerance);

}  // namespace sinew
