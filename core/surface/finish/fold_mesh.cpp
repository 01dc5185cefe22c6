// core/surface/finish/fold_mesh.cpp: vertices are numbered as triangles name them; each lists its triangles.
#include "core/surface/finish/fold_mesh.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace sinew {

void FoldMesh::start(FoldRegion& region, std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch,
                     std::span<const glm::vec3> positions) {
  region_ = &region;
  isBorder_ = isBorder;
  patch_ = patch;
  positions_ = positions;
  for (const FoldVertex& vertex : vertices_) {
    if (toIndex(vertex.index) < localOf_.size()) at(localOf_, vertex.index) = -1;
  }
  localOf_.resize(positions.size(), -1);
  vertices_.clear();
  triangles_.clear();
  moved_.clear();
  round_ = 0;
  gather();
}

int FoldMesh::gathered(int vertex) {
  int& local = at(localOf_, vertex);
  if (local >= 0) return local;
  local = static_cast<int>(vertices_.size());
  FoldVertex& out = vertices_.emplace_back();
  out.index = vertex;
  out.position = out.from = at(positions_, vertex);
  if (at(isBorder_, vertex) == 0) out.most = glm::distance(out.from, at(patch_, vertex));
  return local;
}

void FoldMesh::gather() {
  const std::span<const FoldTriangle> all = region_->triangles();
  next_.resize(3 * all.size());
  for (std::size_t t = triangles_.size(); t < all.size(); ++t) {
    Triangle& triangle = triangles_.emplace_back(Triangle{{}, 0, all[t].face, all[t].whole});
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<int>(3 * t + k);
      triangle.corners[k] = gathered(all[t].corners[k]);
      at(next_, corner) = std::exchange(at(vertices_, triangle.corners[k]).firstCorner, corner);
    }
  }
}

void FoldMesh::grow() {
  region_->grow();
  gather();
}

void FoldMesh::move(int local, const glm::vec3& to) {
  FoldVertex& vertex = at(vertices_, local);
  const glm::vec3 way = to - vertex.from;
  const float length = std::sqrt(glm::dot(way, way));
  vertex.position = vertex.from + (length > vertex.most ? vertex.most / length : 1.0f) * way;
  vertex.hasMoved = true;
}

std::span<const FoldMove> FoldMesh::finish(std::span<glm::vec3> positions) {
  for (const FoldVertex& vertex : vertices_) {
    if (!vertex.hasMoved) continue;
    at(positions, vertex.index) = vertex.position;
    moved_.push_back({vertex.index, vertex.from});
  }
  return moved_;
}

}  // namespace sinew
