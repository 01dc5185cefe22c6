// core/surface/finish/fold_spread.cpp: projection on area constraints, all triangles at once (Jacobi).
#include "core/surface/finish/fold_spread.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/parallel.h"

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

void FoldSpread::ask(int triangle, FoldMesh& mesh) {
  const Fold fold = mesh.foldOf(triangle, kLeastArea);
  if (fold.weight == 0.0f) return;
  mesh.add(triangle);
  const auto [face, whole] = mesh.faceOfPatch(triangle);
  const std::array<int, 3>& corners = mesh.cornersOf(triangle);
  const float area = std::sqrt(whole);
  const glm::vec3 normal = face / area;
  std::array<glm::vec3, 3> gradients;
  float squared = 0.0f;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec3 opposite = mesh.vertex(corners[(i + 2) % 3]).position - mesh.vertex(corners[(i + 1) % 3]).position;
    gradients[i] = glm::cross(normal, opposite);
    squared += glm::dot(gradients[i], gradients[i]);
  }
  const float step = in_float::foldStep(fold.area, area, squared);
  const float weight = in_float::foldWeight(fold.weight, fold.area, step);
  for (std::size_t i = 0; i < 3; ++i) {
    FoldVertex& corner = mesh.vertex(corners[i]);
    if (corner.weight == 0.0f) asked_.push_back(corners[i]);
    corner.weight += weight;
    corner.way += weight * step * gradients[i];
  }
}

void FoldSpread::findFolded(FoldMesh& mesh) {
  constexpr std::size_t kFew = 2048;  // For one thread.
  folded_.resize(toIndex(mesh.triangleCount()));
  const auto list = [&](std::size_t begin, std::size_t end, int* folded) {
    std::size_t count = 0;
    for (std::size_t t = begin; t < end; ++t) {
      folded[count] = static_cast<int>(t);
      count += mesh.foldOf(static_cast<int>(t), kLeastArea).weight != 0.0f ? 1 : 0;
    }
    return count;
  };
  folded_.resize(listInBlocks(folded_.size(), kFew, folded_.data(), list));
}

void FoldSpread::moveAsked(FoldMesh& mesh) {
  moved_.clear();
  for (const int v : asked_) {
    FoldVertex& vertex = mesh.vertex(v);
    const glm::vec3 way = in_float::foldRelaxation(vertex.weight) * vertex.way;
    vertex.weight = 0.0f;
    vertex.way = glm::vec3(0.0f);
    if (vertex.most == 0.0f) continue;
    mesh.move(v, vertex.position + way);
    moved_.push_back(v);
  }
  asked_.clear();
}

/// Treats q >= 0.3 as a constraint on every triangle and projects on it as position based dynamics does (Mueller et al.
/// 2007), all triangles at once (Jacobi).
void FoldSpread::apply(FoldMesh& mesh) {
  findFolded(mesh);
  for (const int t : folded_) ask(t, mesh);
  mesh.grow();
  moveAsked(mesh);
  for (int round = 1; round < kMostRounds && !moved_.empty(); ++round) {
    // A triangle changes only if a corner has moved.
    mesh.forEachAt(moved_, [&](int triangle) { ask(triangle, mesh); });
    mesh.grow();
    moveAsked(mesh);
  }
  moved_.clear();
}

}  // namespace sinew
