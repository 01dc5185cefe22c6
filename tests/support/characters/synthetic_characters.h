// tests/support/characters/synthetic_characters.h: small characters made in code, each with one property to test.
#pragma once

#include <memory>

#include "sinew/character/character.h"

namespace sinew::test {

/// Closed capsule along +Y, 2 units tall, three bones end to end ("root", "middle", "end"), clip "bend" (2 s).
[[nodiscard]] std::shared_ptr<const Character> makeLimb();

/// Closed body of a torso and two legs. Bones: "hips" > "spine", "leg L" > "shin L", "leg R" > "shin R" (L at +X). Clip
/// "cross" (2 s): the legs swing across each other, sideways and back and forth.
[[nodiscard]] std::shared_ptr<const Character> makeTwoLegged();

/// Open flat strip in the XY plane, two bones ("root", "end"), clip "bend" (2 s).
[[nodiscard]] std::shared_ptr<const Character> makeStrip();

/// Closed tube whose texture is cut along a seam and at both caps: welds to fewer vertices than it has wedges.
/// Two bones ("root", "end"), clip "bend" (2 s).
[[nodiscard]] std::shared_ptr<const Character> makeTube();

/// Closed cube, corners at 0 and 1 on every axis, no seam: eight vertices, eight wedges. Bones "root" (the lower four)
/// and "end" (the upper four), clip "bend" (2 s).
[[nodiscard]] std::shared_ptr<const Character> makeCube();

}  // namespace sinew::test
