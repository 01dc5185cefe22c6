// core/include/sinew/smoothing/refinement.h: the N-adic refinement: shared vertices, lattice, wedges. docs/design.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sinew/mesh/control_mesh.h"

namespace sinew {

/// Refined vertices along a control edge as drawn between two wedges at its ends: n-1 drawn vertices from `first` on.
struct DrawnRun {
  int edge = 0;
  std::array<int, 2> wedges{};  ///< At the edge's smaller and larger vertex.
  int first = 0;                ///< Drawn vertex of step 1.
};

/// Topology of a control mesh split n^2. Refined vertices are shared: first the control vertices [0, V), then n-1 per
/// edge from its smaller to its larger vertex, then (n-1)(n-2)/2 per triangle, row by row. Depends on nothing but the
/// mesh and n; made once per depth.
struct Refinement {
  int depth = 1;                              ///< n
  int controlVertices = 0;                    ///< V
  int controlEdges = 0;                       ///< E
  int edgeVertices = 0;                       ///< n-1, per edge.
  int interiorVertices = 0;                   ///< (n-1)(n-2)/2, per control triangle.
  int vertexCount = 0;                        ///< V'
  std::vector<std::array<int, 3>> triangles;  ///< [T n^2] refined vertices; those of control triangle t from t n^2.
  std::vector<int> trianglesAt;               ///< [V'] refined triangles at each vertex.
  std::vector<std::array<int, 2>> interior;   ///< [interiorVertices] (j, k): barycentric (n-j-k, j, k) / n.

  // As drawn and exported: refined vertices split per wedge.
  std::vector<int> drawVertex;       ///< [D] refined vertex of each drawn vertex; the W wedges first.
  std::vector<glm::vec2> drawUv;     ///< [D] barycentric in the parent's wedges (paper 5).
  std::vector<glm::vec4> drawColor;  ///< [D] likewise, linear RGBA; empty where the mesh has no colors.
  std::vector<std::array<std::uint32_t, 3>>
      drawTriangles;               ///< [T n^2] into the drawn vertices, same order as triangles.
  std::vector<DrawnRun> drawRuns;  ///< In order of `first`; none for n = 1.
  std::vector<int>
      drawInterior;  ///< [T] first drawn vertex inside; the others follow, as refined ones do. None for n < 3.

  [[nodiscard]] int edgeVertex(int edge, int step) const {  ///< step 1..n-1 from the edge's smaller vertex.
    return controlVertices + edge * edgeVertices + step - 1;
  }
  [[nodiscard]] int interiorVertex(int triangle, int index) const {
    return controlVertices + controlEdges * edgeVertices + triangle * interiorVertices + index;
  }
};

/// Calls visit(drawn, refined) for every drawn vertex and the refined vertex it shows.
template <class Visit>
void forEachDrawVertex(const Refinement& refinement, Visit visit) {
  for (std::size_t drawn = 0; drawn < refinement.drawVertex.size(); ++drawn) {
    visit(drawn, static_cast<std::size_t>(refinement.drawVertex[drawn]));
  }
}

/// @param depth 1..kMaxDepth.
[[nodiscard]] Refinement refine(const ControlMesh& mesh, int depth);

/// Refined vertices of a mesh without making them: what the memory limit is checked against.
[[nodiscard]] std::int64_t refinedVertexCount(const ControlMesh& mesh, int depth);

}  // namespace sinew
