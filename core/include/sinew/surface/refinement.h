// core/include/sinew/surface/refinement.h: the refined mesh: shared vertices, levels, wedges. docs/design.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sinew/geometry/control_mesh.h"

namespace sinew {

/// Drawn vertices along a control edge between two wedges at its ends: level-1 of them, from `first` on.
struct DrawnRun {
  int edge = 0;
  std::array<int, 2> wedges{};  ///< At the edge's smaller and larger vertex.
  int first = 0;                ///< Drawn vertex of step 1.
};

/// Levels of the edges and triangles of a control mesh, 1..kMaxDepth. Edges have levels of their own, so that their
/// triangles meet vertex by vertex, whatever their inner levels are.
struct RefinementLevels {
  std::vector<std::uint8_t> edges;      ///< [E] segments along each edge.
  std::vector<std::uint8_t> triangles;  ///< [T] the inside has the points of an n^2 split of this level.

  friend bool operator==(const RefinementLevels&, const RefinementLevels&) = default;
};

/// Topology of a refined control mesh. Refined vertices are shared: first the control vertices [0, V), then those on
/// each edge, from its smaller to its larger vertex, then those inside each triangle. A triangle with level n
/// everywhere is split n^2; its inner vertices come row by row. Depends only on the mesh in its bind pose and on the
/// levels. docs/design.md, Refinement.
struct Refinement {
  int depth = 1;                              ///< n if all levels are equal, else the largest.
  bool isUniform = true;                      ///< The N-adic refinement: all levels are equal, nothing is moved.
  int controlVertices = 0;                    ///< V
  int controlEdges = 0;                       ///< E
  int vertexCount = 0;                        ///< V'
  std::vector<int> edgeBegin;                 ///< [E + 1] first refined vertex between an edge's ends.
  std::vector<int> insideBegin;               ///< [T + 1] first refined vertex inside a control triangle.
  std::vector<int> triangleBegin;             ///< [T + 1] first refined triangle of a control triangle.
  std::vector<double> onEdges;                ///< [insideBegin[0] - V] as shareAt(); empty: evenly spaced.
  std::vector<glm::dvec2> inside;             ///< [V' - insideBegin[0]] barycentric (1-x-y, x, y) of inner vertices.
  std::vector<std::array<int, 3>> triangles;  ///< [T'] refined vertices, control triangle by control triangle.
  std::vector<int> controlOf;                 ///< [T'] control triangle of each refined one.
  std::vector<int> trianglesAt;               ///< [V'] refined triangles at each vertex.
  std::vector<int> edgeOrder;                 ///< Edges with inner vertices, those with most first.
  std::vector<int> insideOrder;               ///< Control triangles with inner vertices, those with most first.

  // Drawn and exported vertices: refined vertices split per wedge.
  std::vector<int> drawVertex;       ///< [D] refined vertex of each drawn vertex; the W wedges first.
  std::vector<glm::vec2> drawUv;     ///< [D] barycentric in the parent's wedges (paper 5).
  std::vector<glm::vec4> drawColor;  ///< [D] likewise, linear RGBA; empty if the mesh has no colors.
  std::vector<std::array<std::uint32_t, 3>> drawTriangles;  ///< [T'] into the drawn vertices, same order as triangles.
  std::vector<DrawnRun> drawRuns;                           ///< In order of `first`; none for edges of level 1.
  std::vector<int> drawInside;  ///< [T] first drawn vertex inside; the others follow, as refined ones do.

  [[nodiscard]] int edgeVertices(int edge) const { return of(edgeBegin, edge + 1) - of(edgeBegin, edge); }
  [[nodiscard]] int edgeLevel(int edge) const { return edgeVertices(edge) + 1; }
  [[nodiscard]] int edgeVertex(int edge, int step) const {  ///< step 1..level-1 from the edge's smaller vertex.
    return of(edgeBegin, edge) + step - 1;
  }
  /// Share of the edge's larger vertex, 0..1, ascending along the edge.
  [[nodiscard]] double shareAt(int edge, int step) const {
    if (onEdges.empty()) return static_cast<double>(step) / edgeLevel(edge);
    return onEdges[static_cast<std::size_t>(edgeVertex(edge, step) - controlVertices)];
  }
  [[nodiscard]] int insideVertices(int triangle) const {
    return of(insideBegin, triangle + 1) - of(insideBegin, triangle);
  }
  [[nodiscard]] const glm::dvec2& insideAt(int vertex) const {
    return inside[static_cast<std::size_t>(vertex - insideBegin.front())];
  }
  [[nodiscard]] int refinedTriangles(int triangle) const {
    return of(triangleBegin, triangle + 1) - of(triangleBegin, triangle);
  }

 private:
  [[nodiscard]] static int of(const std::vector<int>& list, int index) { return list[static_cast<std::size_t>(index)]; }
};

/// Calls visit(drawn, refined) for every drawn vertex and its refined vertex.
template <class Visit>
void forEachDrawVertex(const Refinement& refinement, Visit visit) {
  for (std::size_t drawn = 0; drawn < refinement.drawVertex.size(); ++drawn) {
    visit(drawn, static_cast<std::size_t>(refinement.drawVertex[drawn]));
  }
}

/// The same level for every edge and triangle.  @param depth 1..kMaxDepth.
[[nodiscard]] RefinementLevels uniformLevels(const ControlMesh& mesh, int depth);

/// Splits every edge and triangle alike.  @param depth 1..kMaxDepth.
[[nodiscard]] Refinement refine(const ControlMesh& mesh, int depth);

/// @param levels  of this mesh's edges and triangles, each 1..kMaxDepth.
[[nodiscard]] Refinement refine(const ControlMesh& mesh, const RefinementLevels& levels);

/// Number of refined vertices of the N-adic refinement, without making it: for the limit on memory.
[[nodiscard]] std::int64_t refinedVertexCount(const ControlMesh& mesh, int depth);

/// Barycentric coordinates of a refined vertex in its control triangle.
[[nodiscard]] glm::dvec3 controlCoordinates(const ControlMesh& mesh, const Refinement& refinement, int triangle,
                                            int vertex);

}  // namespace sinew
