// core/surface/finish/fold_spread.h: lifted skin must not turn inside out. docs/design.md, Folds.
#pragma once

#include <vector>

#include "core/surface/finish/fold_mesh.h"

namespace sinew {

/// Moves the corners of folded triangles apart, along their patch.
///
/// A triangle with q below 0.3 (fold.h) asks its corners for the least moves that would give it q = 0.3: along the
/// gradients of its area as seen along the patch's face normal. They lie in the patch's plane, so heights stay, and no
/// pit opens. A corner follows the mean of what it is asked for, weighted by how far each q can be trusted and, from q
/// = 0.2 up or where the moves are below 1 % of the edges, by how much is missing; over-relaxed by 1/2. Up to 8
/// rounds, each of which reads the one before alone: the order of triangles does not matter, and what a vertex does is
/// a continuous function of all positions. Vertices that have not moved stay, as do borders.
class FoldSpread {
 public:
  static constexpr float kLeastArea = 0.3f;  ///< q below which a triangle asks.
  static constexpr int kMostRounds = 8;

  /// @param mesh  its region found with kLeastArea.
  void apply(FoldMesh& mesh);

 private:
  void findFolded(FoldMesh& mesh);
  void ask(int triangle, FoldMesh& mesh);
  void moveAsked(FoldMesh& mesh);

  std::vector<int> folded_;  ///< Triangles, before the first round.
  std::vector<int> asked_;   ///< Of the mesh's vertices.
  std::vector<int> moved_;   ///< Those of the last round.
};

}  // namespace sinew
