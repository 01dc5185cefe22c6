// core/smoothing/finish/fold_watch.h: where the next round of a search for folds has to look.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/at.h"
#include "sinew/mesh/control_mesh.h"

namespace sinew {

/// Control triangles that share a vertex with one that has folded. Kept from pose to pose for its memory.
class FoldWatch {
 public:
  void clear(const ControlMesh& mesh) { isNear_.assign(mesh.positions.size(), 0); }

  void add(const ControlTriangle& folding) {
    for (const int v : folding.vertices) at(isNear_, v) = 1;
  }

  /// Those of `control`, in its order. Valid until the next call.
  [[nodiscard]] std::span<const int> around(const ControlMesh& mesh, std::span<const int> control) {
    watched_.clear();
    for (const int t : control) {
      const auto near = [&](int corner) { return at(isNear_, corner) != 0; };
      if (std::ranges::any_of(at(mesh.triangles, t).vertices, near)) watched_.push_back(t);
    }
    return watched_;
  }

 private:
  std::vector<std::uint8_t> isNear_;  ///< [V] a vertex of a triangle that has ever folded.
  std::vector<int> watched_;
};

}  // namespace sinew
