// tests/support/characters/body_with_arms.h: a character with features of real ones: shoulders, an open neck, a fin.
#pragma once

#include <memory>

#include "sinew/character/character.h"

namespace sinew::test {

/// A torso with two arms, 1.4 units tall; the neck is an open hole, and a fin stands on the back, so that along it
/// three triangles meet at an edge. Bones: "hips" > "spine" > "arm L" > "forearm L" > "hand L", likewise R (L at +X),
/// "head"; no skin follows hands and head. Clip "reach" (2 s): one arm goes down to the side and bends, the other one
/// up.
[[nodiscard]] std::shared_ptr<const Character> makeBodyWithArms();

}  // namespace sinew::test
