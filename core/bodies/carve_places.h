// core/bodies/carve_places.h: where a sculpt lies below the skin, as carves.
#pragma once

#include <span>

#include "core/bodies/height_model.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Adds up to `count` carves in a group of their own, apart from one another, where the skin is highest above the
/// sculpt: as long, wide and aligned as the hollow. With a plan each gets its twin and counts once.
/// @param left [V] sculpt minus skin at the control vertices, world units; 0 where not known.  @param plan  or null
[[nodiscard]] Rig withCarves(Rig rig, int count, const SkinPoints& points, std::span<const float> left,
                             const Character& character, const MirrorPlan* plan);

}  // namespace sinew
