// core/geometry/topology.h: what kind of surface a triangle list is.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sinew/geometry/control_mesh.h"

namespace sinew {

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

}  // namespace sinew
