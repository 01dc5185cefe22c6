// core/geometry/weld.h: split file vertices -> geometric vertices + wedges.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/geometry/control_mesh.h"

namespace sinew {

// What kind of surface a triangle list is.

// The edges of a triangle list.

/// Fills the mesh's edges, in order of first use, and those of its triangles, from the triangles' vertices.
void findEdges(ControlMesh& mesh);

/// Counts over a triangle list whose indices name shared (welded) vertices.
struct Topology {
  int vertices = 0;  ///< Used by at least one triangle.
  int edges = 0;     ///< Distinct.
  int triangles = 0;
  std::vector<std::array<int, 2>> borderEdges;       ///< One triangle; smaller vertex first, sorted.
  std::vector<std::array<int, 2>> nonManifoldEdges;  ///< More than two triangles; likewise.

  /// Every edge has exactly two triangles.
  [[nodiscard]] bool closed() const { return triangles > 0 && borderEdges.empty() && nonManifoldEdges.empty(); }
};

[[nodiscard]] Topology topologyOf(std::span<const std::array<int, 3>> triangles);
[[nodiscard]] Topology topologyOf(const ControlMesh& mesh);

/// Vertices of a file that were rounded together, and apart from others: where pieces meet, their places and weights
/// differ by that.
struct RoundedPiece {
  float place = 0.0f;   ///< How far a vertex may lie from where it was.
  float weight = 0.0f;  ///< How far a weight may be from what it was.
};

/// Vertices and triangles as the file splits them (at uv, normal and material seams). Arrays of one length [N].
struct TriangleSoup {
  std::vector<glm::vec3> positions;   ///< [N] bind pose, world space; finite.
  std::vector<glm::vec2> uvs;         ///< [N] finite.
  std::vector<glm::vec4> colors;      ///< [N] linear RGBA, 0..1; or empty: white.
  std::vector<int> influenceBegin;    ///< [N+1]
  std::vector<Influence> influences;  ///< Sorted by binding within a vertex, each binding once, weights > 0, sum 1.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Indices < N, counter-clockwise from outside.
  std::vector<int> materials;                           ///< [triangles]
  std::vector<int> parts;                               ///< [triangles] or empty: all 0.
  std::vector<RoundedPiece> pieces;                     ///< Or empty: nothing was rounded.
  std::vector<int> pieceOf;                             ///< [N] where there are pieces.
};

/// Merges vertices that lie within `tolerance` (1e-6 of the height) of each other and follow the same bindings with
/// the same weights (to 1e-4) into geometric vertices, or of two pieces as far as rounding has moved them; vertices
/// that agree in uv and color too become one wedge. A triangle that loses a corner is dropped and counted; a sliver
/// with three corners stays, for without it a closed mesh would open. Vertices no triangle uses vanish. Fills edges and
/// normals too. Same input, same order of everything. docs/design.md.
/// @param standsFor  filled if not null: [V] the soup vertex that each geometric vertex is.
[[nodiscard]] ControlMesh weld(const TriangleSoup& soup, float tolerance, std::vector<int>* standsFor = nullptr);

/// [soup triangles] The triangle of the welded mesh that each becomes, corner for corner; -1 for those that are
/// dropped.
[[nodiscard]] std::vector<int> weldedTriangles(const TriangleSoup& soup, float tolerance);

/// The same surface as a shape only: vertices at one place become one, whatever bones they follow. Shows where
/// separately moving parts touch. Influences, texture coordinates and colors are not kept.
[[nodiscard]] ControlMesh joinedByPosition(const ControlMesh& mesh, float tolerance);

}  // namespace sinew
