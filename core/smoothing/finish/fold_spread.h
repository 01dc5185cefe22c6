// core/smoothing/finish/fold_spread.h: lifted skin must not turn inside out. docs/design.md, Folds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/smoothing/finish/fold_moves.h"
#include "core/smoothing/finish/fold_region.h"

namespace sinew {

/// Moves the corners of triangles that are still folded apart, along their patch.
///
/// A triangle with q below 0.3 (fold.h) asks its corners for the least moves that would give it q = 0.3: along the
/// gradients of its area as seen along the patch's face normal. They lie in the patch's plane, so heights stay, and no
/// pit opens. A corner follows the mean of what it is asked for, weighted by how far each q can be trusted and, from q
/// = 0.2 up, by how much is missing; over-relaxed by 1/2. Up to 32 rounds, each of which reads the one before alone:
/// the order of triangles does not matter, and what a vertex does is a continuous function of all positions. Vertices
/// that have not moved stay, as do borders.
class FoldSpread {
 public:
  static constexpr int kMostRounds = 32;

  /// @param region  as FoldRelaxation left it.
  /// @param isBorder [V'] borderVertices.  @param patch, positions [V'] world; positions in and out.
  void apply(std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch, FoldRegion& region,
             FoldMoves& moves, std::span<glm::vec3> positions);

 private:
  void ask(bool first, FoldRegion& region, std::span<const glm::vec3> positions);
  void askOf(const FoldTriangle& triangle, const Fold& fold, std::span<const glm::vec3> positions);

  std::vector<float> weights_;         ///< [V'] sum over triangles; 0 but for asked_.
  std::vector<glm::vec3> ways_;        ///< [V'] weighted sum of the moves; 0 but for asked_.
  std::vector<int> asked_;             ///< Vertices.
  std::vector<int> moved_;             ///< Those of the last round.
  std::vector<std::uint8_t> isMoved_;  ///< [V'] 1: in moved_.
};

}  // namespace sinew
