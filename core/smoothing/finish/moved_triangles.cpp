// core/smoothing/finish/moved_triangles.cpp: from moved vertices to the triangles around them.
#include "core/smoothing/finish/moved_triangles.h"

#include <algorithm>

#include "core/base/at.h"

namespace sinew {

void MovedTriangles::find(const ControlMesh& mesh, const Refinement& refinement, std::span<const glm::vec3> patch,
                          std::span<const glm::vec3> positions) {
  moved_.resize(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) moved_[v] = positions[v] != patch[v] ? 1 : 0;
  const auto anyMoved = [&](int first, int count) {
    const auto run = std::span(moved_).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
    return std::ranges::find(run, 1) != run.end();
  };

  movedEdge_.assign(mesh.edges.size(), 0);
  for (int e = 0; e < static_cast<int>(mesh.edges.size()) && refinement.edgeVertices > 0; ++e) {
    at(movedEdge_, e) = anyMoved(refinement.edgeVertex(e, 1), refinement.edgeVertices) ? 1 : 0;
  }
  control.clear();
  corner_.assign(mesh.positions.size(), 0);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const ControlTriangle& triangle = at(mesh.triangles, t);
    const bool holdsMoved = std::ranges::any_of(triangle.vertices, [&](int v) { return at(moved_, v) != 0; }) ||
                            std::ranges::any_of(triangle.edges, [&](int e) { return at(movedEdge_, e) != 0; }) ||
                            anyMoved(refinement.interiorVertex(t, 0), refinement.interiorVertices);
    if (!holdsMoved) continue;
    control.push_back(t);
    for (const int v : triangle.vertices) at(corner_, v) = 1;
  }
  aroundControl.clear();
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto& ends = at(mesh.triangles, t).vertices;
    const auto atMoved = [&](int v) { return at(corner_, v) != 0; };
    if (std::ranges::any_of(ends, atMoved)) aroundControl.push_back(t);
  }

  isNear = moved_;
  const auto flagged = [](const std::vector<std::uint8_t>& flags, const std::array<int, 3>& t) {
    return (at(flags, t[0]) | at(flags, t[1]) | at(flags, t[2])) != 0;
  };
  for (const int t : control) {
    for (const std::array<int, 3>& small : refinedTriangles(refinement, t)) {
      if (!flagged(moved_, small)) continue;
      for (const int v : small) at(isNear, v) = 1;
    }
  }
  refined.clear();
  isCorner_.assign(positions.size(), 0);
  const int perTriangle = refinement.depth * refinement.depth;
  for (const int t : aroundControl) {
    for (int i = t * perTriangle; i < (t + 1) * perTriangle; ++i) {
      const std::array<int, 3>& small = at(refinement.triangles, i);
      if (!flagged(isNear, small)) continue;
      refined.push_back(i);
      for (const int v : small) at(isCorner_, v) = 1;
    }
  }
  const auto list = [](const std::vector<std::uint8_t>& flags, std::vector<int>& out) {
    out.clear();
    for (std::size_t v = 0; v < flags.size(); ++v) {
      if (flags[v] != 0) out.push_back(static_cast<int>(v));
    }
  };
  list(isNear, near);
  list(isCorner_, corners);
}

}  // namespace sinew
