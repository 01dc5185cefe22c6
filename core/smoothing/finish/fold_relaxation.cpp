// core/smoothing/finish/fold_relaxation.cpp: vertices of folded triangles move to the mean of their neighbors.
#include "core/smoothing/finish/fold_relaxation.h"

#include <algorithm>

#include "core/base/smoothstep.h"

namespace sinew {
namespace {

constexpr float kRelaxStep =
    0.2f;                       ///< Of the way to the mean, per round. Whole steps swing, and amplify what is small.
constexpr float kFade = 0.25f;  ///< Change of a weight per round: weights that came and went would swing.

/// How much a lifted triangle asks for, 0..1: all of it from q = 0 on.
float weightOf(const Fold& fold) {
  return fold.weight * (1.0f - smoothstep(0.0f, FoldRelaxation::kWholeArea, fold.area));
}

}  // namespace

void FoldRelaxation::askOf(FoldTriangle& triangle, std::span<const std::uint8_t> isBorder,
                           std::span<const glm::vec3> patch, FoldRegion& region, std::span<const glm::vec3> positions) {
  const float weight = weightOf(region.foldOf(triangle, positions, kWholeArea));
  if (weight == 0.0f) return;
  region.add(triangle);
  for (const int corner : triangle.corners) {
    const auto v = static_cast<std::size_t>(corner);
    if (isBorder[v] != 0 || positions[v] == patch[v]) continue;
    if (asked_[v] == 0.0f) asking_.push_back(corner);
    asked_[v] = std::max(asked_[v], weight);
  }
}

void FoldRelaxation::mergeWeights() {
  for (const int v : folding_) at(weights_, v) = std::max(at(weights_, v) - kFade, at(asked_, v));
  for (const int v : asking_) {
    if (at(weights_, v) < at(asked_, v)) {
      at(weights_, v) = at(asked_, v);
      folding_.push_back(v);
    }
    at(asked_, v) = 0.0f;
  }
  asking_.clear();
  std::erase_if(folding_, [&](int v) {
    at(weights_, v) = std::max(0.0f, at(weights_, v));
    return at(weights_, v) == 0.0f;
  });
}

void FoldRelaxation::findMeans(const VertexRings& rings, std::span<const glm::vec3> positions) {
  means_.clear();
  for (const int v : folding_) {
    const glm::vec3& own = at(positions, v);
    glm::vec3 sum(0.0f);
    for (const int neighbor : rings.at(v)) sum += at(positions, neighbor) - own;
    means_.push_back(own + at(rings.share, v) * sum);
  }
}

/// Moves the corners of folded triangles towards the mean of their neighbors. Such triangles mostly lie on the muscle
/// in the wrong order: the mean restores the order and stays on the muscle, while a move back to the patch would tear a
/// pit into it. Each round reads only the positions that the round before has left (Jacobi), so that the order of
/// triangles does not matter. After the first round only triangles at vertices with a weight are looked at again:
/// nothing else has changed. docs/design.md, Folds.
void FoldRelaxation::apply(const VertexRings& rings, std::span<const std::uint8_t> isBorder,
                           std::span<const glm::vec3> patch, FoldRegion& region, FoldMoves& moves,
                           std::span<glm::vec3> positions) {
  asked_.resize(positions.size());
  weights_.resize(positions.size());
  const auto ask = [&](FoldTriangle& triangle) { askOf(triangle, isBorder, patch, region, positions); };
  const auto hasMoved = [&](int v) { return at(weights_, v) > 0.0f; };
  for (FoldTriangle& triangle : region.triangles()) ask(triangle);
  mergeWeights();
  for (int round = 0; round < kMostRounds && !folding_.empty(); ++round) {
    region.grow();  // All triangles at a folding vertex, and all that its move can fold.
    findMeans(rings, positions);
    for (std::size_t i = 0; i < folding_.size(); ++i) {
      const auto v = toIndex(folding_[i]);
      moves.move(folding_[i], positions[v] + kRelaxStep * weights_[v] * (means_[i] - positions[v]), patch, positions);
    }
    // Elsewhere nothing has changed, and only corners that cannot move could be asked again.
    region.forEachAt(folding_, hasMoved, ask);
    mergeWeights();
  }
  for (const int v : folding_) at(weights_, v) = 0.0f;
  folding_.clear();
  region.grow();
}

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
