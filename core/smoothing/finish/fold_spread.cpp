// core/smoothing/finish/fold_spread.cpp: projection on area constraints, all triangles at once (Jacobi).
#include "core/smoothing/finish/fold_spread.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

constexpr float kLeastArea = 0.3f;   ///< q below which a triangle asks.
constexpr float kWholeLack = 0.1f;   ///< Lack of q from which on it asks with its whole weight.
constexpr float kRelaxation = 1.5f;  ///< Factor on the mean move; above 1: converges faster.

}  // namespace

void FoldSpread::askOf(const FoldTriangle& triangle, const Fold& fold, std::span<const glm::vec3> positions) {
  const float area = std::sqrt(triangle.whole);
  const glm::vec3 normal = triangle.face / area;
  std::array<glm::vec3, 3> gradients;
  float squared = 0.0f;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec3 opposite =
        at(positions, triangle.corners[(i + 2) % 3]) - at(positions, triangle.corners[(i + 1) % 3]);
    gradients[i] = glm::cross(normal, opposite);
    squared += glm::dot(gradients[i], gradients[i]);
  }
  // Where the triangle has shrunk to a line along the normal its gradients vanish: the moves stay small.
  const float step = (kLeastArea - fold.area) * area / std::max(squared, area);
  const float weight = fold.weight * std::min(1.0f, (kLeastArea - fold.area) / kWholeLack);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto v = static_cast<std::size_t>(triangle.corners[i]);
    if (weights_[v] == 0.0f) asked_.push_back(triangle.corners[i]);
    weights_[v] += weight;
    ways_[v] += weight * step * gradients[i];
  }
}

void FoldSpread::ask(bool first, FoldRegion& region, std::span<const glm::vec3> positions) {
  const auto askAbout = [&](FoldTriangle& triangle) {
    const Fold fold = region.foldOf(triangle, positions, kLeastArea);
    if (fold.weight == 0.0f) return;
    region.add(triangle);
    askOf(triangle, fold, positions);
  };
  if (first) {
    for (FoldTriangle& triangle : region.triangles()) askAbout(triangle);
  } else {
    // Where no corner was asked in the last round nothing has changed.
    region.forEachAt(
        moved_, [&](int v) { return at(isMoved_, v) != 0; }, askAbout);
  }
  region.grow();
}

/// Solves q >= 0.3 for every triangle as a constraint on its area, by the projection step of position based dynamics
/// (Mueller et al. 2007): each corner moves along the gradient of the area, by the constraint's lack over the sum of
/// the squared gradients. Where two cushions of flesh press on each other the mean of the neighbors is folded too, and
/// relaxation alone leaves the fold. A corner takes the weighted mean of what all its triangles ask for (Jacobi), so
/// that the order of triangles does not matter. docs/design.md, Folds.
void FoldSpread::apply(std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch, FoldRegion& region,
                       FoldMoves& moves, std::span<glm::vec3> positions) {
  weights_.resize(positions.size());
  ways_.resize(positions.size());
  isMoved_.resize(positions.size());
  for (int round = 0; round < kMostRounds; ++round) {
    ask(round == 0, region, positions);
    for (const int v : moved_) at(isMoved_, v) = 0;
    moved_.clear();
    for (const int vertex : asked_) {
      const auto v = static_cast<std::size_t>(vertex);
      const glm::vec3 way = kRelaxation / std::max(1.0f, weights_[v]) * ways_[v];
      weights_[v] = 0.0f;
      ways_[v] = glm::vec3(0.0f);
      if (isBorder[v] != 0 || positions[v] == patch[v]) continue;
      moves.move(vertex, positions[v] + way, patch, positions);
      isMoved_[v] = 1;
      moved_.push_back(vertex);
    }
    asked_.clear();
    if (moved_.empty()) break;
  }
  for (const int v : moved_) at(isMoved_, v) = 0;
  moved_.clear();
}

}  // namespace sinew
