// core/surface/face_culling.cpp: triangles whose vertex normals point away, and what lies only at them.
#include "core/surface/face_culling.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"

namespace sinew {

void cullFaces(const ControlMesh& mesh, const Refinement& refinement, const SkinnedMesh& control, const glm::vec3& eye,
               FaceCulling& out) {
  const auto pointsAway = [&](int vertex) {
    return glm::dot(at(control.normals, vertex), at(control.positions, vertex) - eye) > 0.0f;
  };
  const auto firstEdge = static_cast<std::size_t>(refinement.controlVertices);
  const std::size_t firstTriangle = firstEdge + static_cast<std::size_t>(refinement.controlEdges);
  out.culled = 0;
  out.carriers.assign(firstTriangle + mesh.triangles.size(), 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (std::ranges::all_of(mesh.triangles[t].vertices, pointsAway)) {
      ++out.culled;
      continue;
    }
    out.carriers[firstTriangle + t] = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      at(out.carriers, mesh.triangles[t].vertices[i]) = 0;
      out.carriers[firstEdge + static_cast<std::size_t>(mesh.triangles[t].edges[i])] = 0;
    }
  }
}

}  // namespace sinew
