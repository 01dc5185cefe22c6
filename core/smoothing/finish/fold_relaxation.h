// core/smoothing/finish/fold_relaxation.h: folds of lifted skin are smoothed out. docs/design.md, Folds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/smoothing/finish/fold_moves.h"
#include "core/smoothing/finish/fold_region.h"

namespace sinew {

/// Smooths lifted skin where refined triangles fold over.
///
/// The corners of a triangle with q below 0.4 (fold.h) are moved towards the mean of their neighbors, by a fifth of the
/// way from q = 0 on, weighted by how far q can be trusted: neighbors come back towards their order, and the skin stays
/// on the muscle. A weight that is no longer asked for falls by 1/4 a round. Up to 6 rounds, each of which reads the
/// one before alone: the order of triangles does not matter. Vertices that have not moved stay, as do borders, and the
/// result is continuous in time.
class FoldRelaxation {
 public:
  /// q below which a triangle is relaxed.
  static constexpr float kWholeArea = 0.4f;
  static constexpr int kMostRounds = 6;

  /// @param rings  of the refinement.  @param region  found with kWholeArea.
  /// @param isBorder [V'] borderVertices.  @param patch, positions [V'] world; positions in and out.
  void apply(const VertexRings& rings, std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch,
             FoldRegion& region, FoldMoves& moves, std::span<glm::vec3> positions);

 private:
  void askOf(FoldTriangle& triangle, std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch,
             FoldRegion& region, std::span<const glm::vec3> positions);
  void mergeWeights();
  void findMeans(const VertexRings& rings, std::span<const glm::vec3> positions);

  std::vector<float> asked_;  ///< [V'] weights of this round; 0 but for asking_.
  std::vector<int> asking_;
  std::vector<float> weights_;    ///< [V'] 0 but for folding_.
  std::vector<int> folding_;      ///< Vertices with a weight in this round.
  std::vector<glm::vec3> means_;  ///< [folding_] of the neighbors.
};

/// [V'] 1: on an edge with a single triangle. (Where more than two meet they share their vertices: nothing can open.)
[[nodiscard]] std::vector<std::uint8_t> borderVertices(const ControlMesh& mesh, const Refinement& refinement);

}  // namespace sinew
