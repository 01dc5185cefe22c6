// core/surface/finish/slope_bound.h: how steeply heights may rise over the skin. docs/design.md, Slopes.
#pragma once

#include <span>
#include <vector>

#include "core/surface/finish/lifted_heights.h"

namespace sinew {

/// Lowers heights until none rises by more than kSlope times the length of any path over the patch, along edges and
/// straight from one triangle's corner to the next one's, across the edge between them: paths along edges alone are up
/// to 15 % too long, in directions that depend on the mesh. |s(p)| becomes the least, over all vertices q and paths
/// from q to p, of max(0, s(q) with the sign of s(p)) + kSlope times the path. Heights keep their sign, what has not
/// moved stays, and no difference between two moments grows. The result is unique, to the bit: it depends neither on
/// the order of triangles nor on where the search begins.
class SlopeBound {
 public:
  /// Wherever a muscle's flank is no steeper than 56 degrees it stays as it is.
  static constexpr float kSlope = 1.5f;

  /// @param heights  in and out.  @return the vertices that were lowered, each once. Valid until
  /// the next call.
  std::span<const int> lower(LiftedHeights& heights);

 private:
  /// A height that a neighbor leaves a vertex.
  struct Offer {
    float height = 0.0f;
    int vertex = 0;
  };
  void offer(float height, int vertex);
  void findSteep(const LiftedHeights& heights);

  std::vector<int> steep_;
  std::vector<Offer> offers_;  ///< A heap, the lowest first.
  std::vector<int> lowered_;
};

}  // namespace sinew
