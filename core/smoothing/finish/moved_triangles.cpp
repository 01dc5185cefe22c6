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
  isControl.assign(mesh.triangles.size(), 0);
  for (const int v : moved_) {
    for (const int corner : rings.cornersOf(v)) at(isControl, at(refinement.controlOf, corner / 3)) = 1;
  }
  flagAround(moved_, rings, isNear);
  list(isNear, near);
  flagAround(near, rings, isCorner_);
  list(isCorner_, corners);
  isRefined_.assign(refinement.triangles.size(), 0);
  for (const int v : near) {
    for (const int corner : rings.cornersOf(v)) at(isRefined_, corner / 3) = 1;
  }
  list(isRefined_, refined);
}

}  // namespace sinew
