// core/character/skin_bones.h: which bones of a character carry its skin.
#pragma once

#include <vector>

#include "sinew/character/character.h"

namespace sinew {

/// [bones] Skin follows it.
[[nodiscard]] std::vector<bool> bonesWithSkin(const Character& character);

/// [bones] No skin follows it nor any bone below it (core/character/helper_bones.h).
[[nodiscard]] std::vector<bool> helperBones(const Character& character);

}  // namespace sinew
