// core/runtime/game_check.h: what makes a character that was read one that everything else can rely on.
#pragma once

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"

namespace sinew::gamefile {

/// Checks every index, order and range of what core/runtime/layout.h has read, and completes the skeleton. Edges and
/// normals are still to be made.
[[nodiscard]] Result<void> checkCharacter(Character& character);

}  // namespace sinew::gamefile
