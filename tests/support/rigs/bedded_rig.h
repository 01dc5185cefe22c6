// tests/support/rigs/bedded_rig.h: muscles under the skin of one bone each, whose surface should move smoothly over
// time.
#pragma once

#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::test {

/// `muscles` ellipsoids as a careful designer places them: inside the body where the skin around follows one bone
/// alone, most of the thickness under the skin, moving that bone's skin only (territory). Bones with the most space
/// first; one group. None where no bone has space.
[[nodiscard]] Rig beddedRig(const Character& character, int muscles);

}  // namespace sinew::test
