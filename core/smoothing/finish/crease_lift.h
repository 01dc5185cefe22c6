// core/smoothing/finish/crease_lift.h: heights where the pose folds the skin itself. docs/design.md, Creases of a pose.
#pragma once

#include <span>
#include <vector>

#include "core/smoothing/finish/fold.h"
#include "core/smoothing/finish/moved_triangles.h"

namespace sinew {

/// Lowers muscles in the crease of a bent joint. There the bare skin is folded and hidden, and muscles that lifted both
/// banks would lift them through each other. With rho the least front of the patch's triangles at a vertex over that in
/// the bind pose (fold.h), its height falls to 0.4 + 0.6 smoothstep(-0.3, 0.4, rho) of itself. Triangles that are all
/// but edge-on in the bind pose, front below 0.05, have no say. Continuous in time.
class CreaseLift {
 public:
  /// @param heights [V'] in and out.
  void lower(const Refinement& refinement, const MovedTriangles& moved, const PatchView& patch,
             std::span<float> heights);

 private:
  std::vector<float> fronts_;  ///< [V'] rho, but at most kLevel.
  std::vector<int> folded_;    ///< Vertices below that.
};

}  // namespace sinew
