// core/surface/split_check.h: levels raised until each triangle's split, as it will be made, follows the surface.
#pragma once

#include <vector>

#include "core/surface/patches/split_triangle.h"
#include "core/surface/preparation.h"
#include "sinew/character/pose.h"
#include "sinew/surface/refinement.h"

namespace sinew {

struct CheckedSplit {
  SplitLevels levels;
  bool fits = false;

  friend bool operator==(const CheckedSplit&, const CheckedSplit&) = default;
};

/// [T] what is known of each triangle's splits: it follows from the triangle's own surface alone.
using CheckedSplits = std::vector<std::vector<CheckedSplit>>;

/// Graded levels, at least `needed`, at which samples of all splits lie within the tolerance of their flat pieces. The
/// fit knows the n^2 split alone; where sides and inside differ, points lie elsewhere. A triangle that fails gets sides
/// as fine as its inside, else a finer inside, a few times at most.
/// @param next  as for findLevels()
/// @param tolerance  world units
/// @param known  read, and added to
[[nodiscard]] RefinementLevels levelsThatFit(const Preparation& next, const std::vector<Pose>& poses, float tolerance,
                                             RefinementLevels needed, CheckedSplits& known);

}  // namespace sinew
