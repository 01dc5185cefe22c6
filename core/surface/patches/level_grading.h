// core/surface/patches/level_grading.h: levels raised until neighbors are alike.
#pragma once

#include <array>
#include <vector>

#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Levels that are raised to: most divide each other.
inline constexpr std::array kGradedLevels{1, 2, 3, 4, 6, 12, 16};

/// Raises levels to the least ones of kGradedLevels at which no side of a triangle, and not its inside, is
/// split into pieces more than three times as long as another's, unless it has as high a level: jumps in size make
/// slivers, and equal levels keep the triangle's own shape. Lengths are the bind pose's.
class LevelGrader {
 public:
  /// @param mesh  must outlive this.
  explicit LevelGrader(const ControlMesh& mesh);

  /// Nothing is lowered; the result is the same in whatever order triangles are looked at.
  [[nodiscard]] RefinementLevels graded(RefinementLevels levels) const;

 private:
  const ControlMesh& mesh_;
  std::vector<float> lengths_;       ///< [E]
  std::vector<int> trianglesBegin_;  ///< [E + 1] into trianglesAt_.
  std::vector<int> trianglesAt_;     ///< Edge by edge.
};

}  // namespace sinew
