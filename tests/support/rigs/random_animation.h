// tests/support/rigs/random_animation.h: random keys, drivers and channels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sinew/rig/rig.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {

/// Channels, and for some numbers of every kind of owner keys and drivers of every input that the rig allows. Valid.
/// @param bones  that inputs name
/// @param clips  that tracks name
void addAnimation(Random& random, const std::vector<std::string>& bones, const std::vector<std::string>& clips,
                  Rig& rig);

/// Four muscles on a limb (makeLimb), two of them on a line, some shaped, animated in every way.
[[nodiscard]] Rig animatedLimbRig(const Character& limb, std::uint64_t seed);

/// 1..most points, x rising by at least 0.01 from `least`.
[[nodiscard]] Curve anyCurve(Random& random, float least, float range, int most);

}  // namespace sinew::test
