// core/smoothing/finish/fold_relaxation.cpp: vertices of folded triangles move to the mean of their neighbours.
#include "core/smoothing/finish/fold_relaxation.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/base/smoothstep.h"
#include "core/smoothing/finish/moved_triangles.h"

namespace sinew {
namespace {

constexpr int kRounds = 32;
constexpr float kFoldedArea = 0.0f;  ///< q up to which a triangle asks for all.
constexpr float kWholeArea = 0.4f;   ///< q from which it is let be.
constexpr float kFade = 0.25f;       ///< Of a weight, per round: weights that came and went would swing.

/// How much a lifted triangle asks for, 0..1.
float weightOf(const Fold& fold) { return fold.weight * (1.0f - smoothstep(kFoldedArea, kWholeArea, fold.area)); }

}  // namespace

void FoldRelaxation::weigh(const ControlMesh& mesh, const Refinement& refinement, std::span<const int> control,
                           bool onlyRelaxed, const PatchView& patch, std::span<const std::uint8_t> isBorder,
                           std::span<const glm::vec3> positions) {
  std::erase_if(folding_, [&](int vertex) {
    float& weight = at(weights_, vertex);
    weight = std::max(0.0f, weight - kFade);
    return weight == 0.0f;
  });
  const auto relaxed = [&](int v) { return at(isRelaxed_, v) != 0; };
  const int perTriangle = refinement.depth * refinement.depth;
  for (const int t : control) {
    bool folds = false;
    for (int i = t * perTriangle; i < (t + 1) * perTriangle; ++i) {
      const auto index = static_cast<std::size_t>(i);
      const std::array<int, 3>& small = refinement.triangles[index];
      if (onlyRelaxed && std::ranges::none_of(small, relaxed)) continue;
      const float weight = weightOf(foldOf(refinement, index, patch, positions, kWholeArea));
      if (weight == 0.0f) continue;
      folds = true;
      for (const int corner : small) {
        const auto v = static_cast<std::size_t>(corner);
        if (isBorder[v] || positions[v] == patch.positions[v]) continue;
        if (weights_[v] == 0.0f) folding_.push_back(corner);
        weights_[v] = std::max(weights_[v], weight);
      }
    }
    if (folds) watch_.add(at(mesh.triangles, t));
  }
}

void FoldRelaxation::sumNeighbours(const Refinement& refinement, std::span<const int> control,
                                   std::span<const glm::vec3> positions) {
  for (const int v : folding_) at(sums_, v) = glm::vec3(0.0f);
  for (const int t : control) {
    for (const std::array<int, 3>& small : refinedTriangles(refinement, t)) {
      const auto a = static_cast<std::size_t>(small[0]);
      const auto b = static_cast<std::size_t>(small[1]);
      const auto c = static_cast<std::size_t>(small[2]);
      if (weights_[a] > 0.0f) sums_[a] += positions[b] + positions[c];
      if (weights_[b] > 0.0f) sums_[b] += positions[c] + positions[a];
      if (weights_[c] > 0.0f) sums_[c] += positions[a] + positions[b];
    }
  }
}

void FoldRelaxation::move(const Refinement& refinement, const PatchView& patch, std::span<glm::vec3> positions) {
  for (const int vertex : folding_) {
    const auto v = static_cast<std::size_t>(vertex);
    if (!isRelaxed_[v]) {
      isRelaxed_[v] = 1;
      from_[v] = positions[v];
      relaxed_.push_back({vertex, positions[v]});
    }
    const glm::vec3 mean = sums_[v] / static_cast<float>(2 * refinement.trianglesAt[v]);
    const glm::vec3 way = positions[v] + weights_[v] * (mean - positions[v]) - from_[v];
    const float most = glm::distance(from_[v], patch.positions[v]);
    const float length = std::sqrt(glm::dot(way, way));
    positions[v] = from_[v] + (length > most ? most / length : 1.0f) * way;
  }
}

std::span<const Relaxed> FoldRelaxation::apply(const ControlMesh& mesh, const Refinement& refinement,
                                               std::span<const int> control, const PatchView& patch,
                                               std::span<const std::uint8_t> isBorder, std::span<glm::vec3> positions) {
  relaxed_.clear();
  folding_.clear();
  weights_.assign(positions.size(), 0.0f);
  watch_.clear(mesh);
  weigh(mesh, refinement, control, false, patch, isBorder, positions);
  watched_ = watch_.around(mesh, control);
  if (folding_.empty()) return {};
  sums_.resize(positions.size());
  from_.resize(positions.size());
  isRelaxed_.assign(positions.size(), 0);
  for (int round = 0; round < kRounds && !folding_.empty(); ++round) {
    // All triangles at a folding vertex, and all that its move can fold.
    sumNeighbours(refinement, watched_, positions);
    move(refinement, patch, positions);
    // Where no corner has moved, nothing has changed, and nothing could ask but for unmoved corners.
    weigh(mesh, refinement, watched_, true, patch, isBorder, positions);
    watched_ = watch_.around(mesh, control);
  }
  return relaxed_;
}

std::vector<std::uint8_t> borderVertices(const ControlMesh& mesh, const Refinement& refinement) {
  std::vector<std::uint8_t> out(static_cast<std::size_t>(refinement.vertexCount), 0);
  for (int e = 0; e < static_cast<int>(mesh.edges.size()); ++e) {
    const Edge& edge = at(mesh.edges, e);
    if (edge.triangleCount == 2) continue;
    for (const int end : edge.vertices) at(out, end) = 1;
    for (int step = 1; step < refinement.depth; ++step) {
      at(out, refinement.edgeVertex(e, step)) = 1;
    }
  }
  return out;
}

}  // namespace sinew
