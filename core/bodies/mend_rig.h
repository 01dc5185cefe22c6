// core/bodies/mend_rig.h: all that is found of a rig's muscles, mended. docs/muscles.md.
#pragma once

#include <cstddef>
#include <vector>

#include "core/bodies/mend.h"

namespace sinew {

/// check(), of the primitives from `first` on.
[[nodiscard]] std::vector<Finding> findingsFrom(const Rig& rig, std::size_t first, const Motions& motions);

/// Lines first (withMendedFindings); of what is still found, what a muscle rides and how deep it lies
/// (withMendedBelly); skin of another limb goes from territories. Something may be left.
/// @param plan  null: twins stay as they are
[[nodiscard]] Result<MendedRig> withMendedRig(Rig rig, std::size_t first, const Motions& motions,
                                              const MirrorPlan* plan);

}  // namespace sinew
