// core/smoothing/finish/moved_triangles.cpp: from moved vertices to the triangles around them.
#include "core/smoothing/finish/moved_triangles.h"

#include <algorithm>

#include "core/base/at.h"

namespace sinew {
namespace {

/// What is flagged, ascending. Without a branch: flags change too often to be foreseen.
void list(const std::vector<std::uint8_t>& flags, std::vector<int>& out) {
  out.resize(flags.size());
  std::size_t count = 0;
  for (std::size_t v = 0; v < flags.size(); ++v) {
    out[count] = static_cast<int>(v);
    count += flags[v];
  }
  out.resize(count);
}

/// Flags vertices and their neighbors.
void flagAround(std::span<const int> vertices, const VertexRings& rings, std::vector<std::uint8_t>& flags) {
  flags.assign(rings.share.size(), 0);
  for (const int v : vertices) {
    at(flags, v) = 1;
    for (const int neighbor : rings.at(v)) at(flags, neighbor) = 1;
  }
}

}  // namespace

void MovedTriangles::find(const ControlMesh& mesh, const Refinement& refinement, const VertexRings& rings,
                          std::span<const glm::vec3> patch, std::span<const glm::vec3> positions) {
  isMoved_.resize(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const glm::vec3& p = patch[v];
    const glm::vec3& q = positions[v];
    isMoved_[v] = static_cast<std::uint8_t>((p.x != q.x) | (p.y != q.y) | (p.z != q.z));
  }
  list(isMoved_, moved_);
  findControl(mesh, refinement);
  flagAround(moved_, rings, isNear);
  list(isNear, near);
  flagAround(near, rings, isCorner_);
  list(isCorner_, corners);
  findRefined(mesh, refinement);
}

void MovedTriangles::findControl(const ControlMesh& mesh, const Refinement& refinement) {
  const auto anyMoved = [&](int first, int count) {
    const auto run = std::span(isMoved_).subspan(toIndex(first), toIndex(count));
    return std::ranges::find(run, 1) != run.end();
  };
  isMovedEdge_.assign(mesh.edges.size(), 0);
  for (int e = 0; e < refinement.controlEdges; ++e) {
    at(isMovedEdge_, e) = anyMoved(refinement.edgeVertex(e, 1), refinement.edgeVertices(e)) ? 1 : 0;
  }
  control.clear();
  isEnd_.assign(mesh.positions.size(), 0);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const ControlTriangle& triangle = at(mesh.triangles, t);
    const bool holdsMoved = std::ranges::any_of(triangle.vertices, [&](int v) { return at(isMoved_, v) != 0; }) ||
                            std::ranges::any_of(triangle.edges, [&](int e) { return at(isMovedEdge_, e) != 0; }) ||
                            anyMoved(at(refinement.insideBegin, t), refinement.insideVertices(t));
    if (!holdsMoved) continue;
    control.push_back(t);
    for (const int v : triangle.vertices) at(isEnd_, v) = 1;
  }
}

void MovedTriangles::findRefined(const ControlMesh& mesh, const Refinement& refinement) {
  refined.resize(refinement.triangles.size());
  std::size_t count = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto& ends = at(mesh.triangles, t).vertices;
    if (std::ranges::none_of(ends, [&](int v) { return at(isEnd_, v) != 0; })) continue;
    for (int i = at(refinement.triangleBegin, t); i < at(refinement.triangleBegin, t + 1); ++i) {
      const std::array<int, 3>& small = at(refinement.triangles, i);
      refined[count] = i;
      count += at(isNear, small[0]) | at(isNear, small[1]) | at(isNear, small[2]);
    }
  }
  refined.resize(count);
}

}  // namespace sinew
