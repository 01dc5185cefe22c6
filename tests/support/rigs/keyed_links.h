// tests/support/rigs/keyed_links.h: rigs whose links have other amounts at each moment of a clip.
#pragma once

#include <cstdint>

#include "sinew/character/animation_clip.h"
#include "sinew/rig/rig.h"

namespace sinew::test {

/// Keys of all links but every fourth: their amounts cross, are equal for a while, and reach 0 and 1.
[[nodiscard]] Rig withKeyedLinks(Rig rig, const AnimationClip& clip, std::uint64_t seed);
[[nodiscard]] Rig withoutKeys(Rig rig);  ///< Of the links.

}  // namespace sinew::test
