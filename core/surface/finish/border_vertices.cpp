// core/surface/finish/border_vertices.cpp: the ends of open control edges, and all that refinement puts between them.
#include "core/surface/finish/border_vertices.h"

#include "core/geometry/at.h"

namespace sinew {

std::vector<std::uint8_t> borderVertices(const ControlMesh& mesh, const Refinement& refinement) {
  std::vector<std::uint8_t> out(static_cast<std::size_t>(refinement.vertexCount), 0);
  for (int e = 0; e < static_cast<int>(mesh.edges.size()); ++e) {
    const Edge& edge = at(mesh.edges, e);
    if (edge.triangleCount > 1) continue;
    for (const int end : edge.vertices) at(out, end) = 1;
    for (int step = 1; step <= refinement.edgeVertices(e); ++step) {
      at(out, refinement.edgeVertex(e, step)) = 1;
    }
  }
  return out;
}

}  // namespace sinew
