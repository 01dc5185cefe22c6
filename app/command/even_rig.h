// app/command/even_rig.h: any number of muscles over the whole body, always as many at a place.
#pragma once

#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// `muscles` balls spread evenly over the bound skin, each half under it and of such a radius that kEvenOverlap of them
/// reach a place of the skin whatever their number: what is left to compare is the search for those. Each rides the
/// bone that its skin follows most; one group, no territories of its own. The character has a triangle with an area.
[[nodiscard]] Rig evenRig(const Character& character, int muscles);

inline constexpr float kEvenOverlap = 5.0f;

}  // namespace sinew::app
