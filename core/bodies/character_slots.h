// core/bodies/character_slots.h: the parts of a character's body, with what a rig says of them.
#pragma once

#include <span>

#include "core/character/body_slots.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// @param plan  of the character
/// @param corrections  of the rig: a bone that the character lacks leaves its part as it was found
[[nodiscard]] BodySlots bodySlots(const Character& character, const MirrorPlan& plan,
                                  std::span<const SlotCorrection> corrections = {});

}  // namespace sinew
