// core/smoothing/finish/fold_spread.cpp: projection on area constraints, all triangles at once (Jacobi).
#include "core/smoothing/finish/fold_spread.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sinew {
namespace {

constexpr float kLeastArea = 0.3f;   ///< q below which a triangle asks.
constexpr float kWholeLack = 0.1f;   ///< Lack of q from which on it asks with its whole weight.
constexpr float kRelaxation = 1.5f;  ///< Factor on the mean move; above 1: converges faster.

}  // namespace

int FoldSpread::localOf(int vertex, std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch,
                        const FoldMoves& moves, std::span<const glm::vec3> positions) {
  int& local = at(localOf_, vertex);
  if (local >= 0) return local;
  local = static_cast<int>(vertices_.size());
  Vertex& out = vertices_.emplace_back();
  out.index = vertex;
  out.position = at(positions, vertex);
  out.from = moves.fromOf(vertex, positions);
  const bool stays = at(isBorder, vertex) != 0 || out.position == at(patch, vertex);
  out.most = stays ? 0.0f : glm::distance(out.from, at(patch, vertex));
  return local;
}

void FoldSpread::gather(std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch, FoldRegion& region,
                        const FoldMoves& moves, std::span<const glm::vec3> positions) {
  const std::span<const FoldTriangle> all = region.triangles();
  next_.resize(3 * all.size());
  for (std::size_t t = triangles_.size(); t < all.size(); ++t) {
    Triangle& triangle = triangles_.emplace_back(Triangle{{}, -1, all[t].face, all[t].whole});
    for (std::size_t k = 0; k < 3; ++k) {
      const int local = localOf(all[t].corners[k], isBorder, patch, moves, positions);
      triangle.corners[k] = local;
      next_[3 * t + k] = std::exchange(at(vertices_, local).firstCorner, static_cast<int>(3 * t + k));
    }
  }
}

void FoldSpread::ask(int index, FoldRegion& region) {
  const Triangle& triangle = at(triangles_, index);
  const std::array<Vertex*, 3> corners{&at(vertices_, triangle.corners[0]), &at(vertices_, triangle.corners[1]),
                                       &at(vertices_, triangle.corners[2])};
  const glm::vec3& a = corners[0]->position;
  const glm::vec3 face = glm::cross(corners[1]->position - a, corners[2]->position - a);
  const float left = glm::dot(face, triangle.face);
  if (!(left < kLeastArea * triangle.whole)) return;
  FoldTriangle& folding = at(region.triangles(), index);
  const float trust = region.trustOf(folding);
  if (trust == 0.0f) return;
  region.add(folding);

  const float area = std::sqrt(triangle.whole);
  const float lack = kLeastArea - left / triangle.whole;
  const glm::vec3 normal = triangle.face / area;
  std::array<glm::vec3, 3> gradients;
  float squared = 0.0f;
  for (std::size_t i = 0; i < 3; ++i) {
    gradients[i] = glm::cross(normal, corners[(i + 2) % 3]->position - corners[(i + 1) % 3]->position);
    squared += glm::dot(gradients[i], gradients[i]);
  }
  // Where the triangle has shrunk to a line along the normal its gradients vanish: the moves stay small.
  const float step = lack * area / std::max(squared, area);
  const float weight = trust * std::min(1.0f, lack / kWholeLack);
  for (std::size_t i = 0; i < 3; ++i) {
    Vertex& corner = *corners[i];
    if (corner.weight == 0.0f) asked_.push_back(triangle.corners[i]);
    corner.weight += weight;
    corner.way += weight * step * gradients[i];
  }
}

void FoldSpread::moveAsked() {
  moved_.clear();
  for (const int v : asked_) {
    Vertex& vertex = at(vertices_, v);
    const glm::vec3 way = kRelaxation / std::max(1.0f, vertex.weight) * vertex.way;
    vertex.weight = 0.0f;
    vertex.way = glm::vec3(0.0f);
    if (vertex.most == 0.0f) continue;
    vertex.position = FoldMoves::limited(vertex.from, vertex.most, vertex.position + way);
    vertex.hasMoved = true;
    moved_.push_back(v);
  }
  asked_.clear();
}

/// Solves q >= 0.3 for every triangle as a constraint on its area, by the projection step of position based dynamics
/// (Mueller et al. 2007): each corner moves along the gradient of the area, by the constraint's lack over the sum of
/// the squared gradients. Where two cushions of flesh press on each other the mean of the neighbors is folded too, and
/// relaxation alone leaves the fold. A corner takes the weighted mean of what all its triangles ask for (Jacobi), so
/// that the order of triangles does not matter. docs/design.md, Folds.
void FoldSpread::apply(std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch, FoldRegion& region,
                       FoldMoves& moves, std::span<glm::vec3> positions) {
  localOf_.resize(positions.size(), -1);
  gather(isBorder, patch, region, moves, positions);
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) ask(t, region);
  for (int round = 0; round < kMostRounds; ++round) {
    // Where no corner has moved nothing has changed.
    for (const int v : moved_) {
      for (int corner = at(vertices_, v).firstCorner; corner >= 0; corner = at(next_, corner)) {
        Triangle& triangle = at(triangles_, corner / 3);
        if (std::exchange(triangle.round, round) != round) ask(corner / 3, region);
      }
    }
    region.grow();
    gather(isBorder, patch, region, moves, positions);
    moveAsked();
    if (moved_.empty()) break;
  }
  for (const Vertex& vertex : vertices_) {
    if (vertex.hasMoved) moves.place(vertex.index, vertex.position, positions);
    at(localOf_, vertex.index) = -1;
  }
  vertices_.clear();
  triangles_.clear();
  moved_.clear();
}

}  // namespace sinew
