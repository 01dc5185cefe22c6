// core/character/helper_bones.h: bones that move no skin: targets, poles, sockets, ends.
#pragma once

#include <vector>

#include "sinew/character/skeleton.h"

namespace sinew {

/// [bones] Skin follows the bone or one below it. @param carriesSkin  [bones] skin follows it; empty: all do.
[[nodiscard]] std::vector<bool> bonesThatMoveSkin(const Skeleton& skeleton, const std::vector<bool>& carriesSkin);

/// [bones] The others: what a designer of muscles need not see. None where no bone moves skin.
[[nodiscard]] std::vector<bool> helperBones(const Skeleton& skeleton, const std::vector<bool>& carriesSkin);

}  // namespace sinew
