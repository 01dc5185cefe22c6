// core/character/limb_parts.h: which bone of a limb is which part of it.
#pragma once

#include <span>
#include <vector>

#include "core/character/limb_chains.h"

namespace sinew {

/// The bone of each part, in the order of `parts`, each further out than the one before.
/// @param parts  from the trunk outwards, of one limb
[[nodiscard]] std::vector<SlotBone> partsOfLimb(const SlotSearch& search, const LimbChain& chain,
                                                std::span<const Slot> parts);

}  // namespace sinew
