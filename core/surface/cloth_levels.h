// core/surface/cloth_levels.h: cloth is split as finely as the skin that moves it.
#pragma once

#include "core/surface/preparation.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Levels at which pieces of cloth are no longer than those of the skin under their corners, where that skin sees
/// muscles. Never less than they were.
/// @param next  attached  @param levels  in which the skin's are found
[[nodiscard]] RefinementLevels withClothLevels(const Preparation& next, RefinementLevels levels);

}  // namespace sinew
