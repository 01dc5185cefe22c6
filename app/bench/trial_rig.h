// app/bench/trial_rig.h: muscles set by rule, for measurements and tests.
#pragma once

#include <cstdint>

#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// `muscles` ellipsoids as a first try would set them: on the bones with the most skin, one each (more where they are
/// few), lying along the bone, half buried in the skin at a vertex of that bone's which the seed picks. Three groups in
/// a chain a - b - c, default territories, no carves. The same character, count and seed give the same rig.
[[nodiscard]] Rig trialRig(const Character& character, int muscles, std::uint64_t seed);

}  // namespace sinew
