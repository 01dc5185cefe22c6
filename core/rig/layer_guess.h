// core/rig/layer_guess.h: what the parts of a mesh probably are: skin, cloth over it, or rigid. docs/characters.md.
#pragma once

#include <vector>

#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// [parts] From the bind pose, names and materials alone; all skin where there is one part, and wherever in doubt:
/// - sewn to other parts along most of its border: skin, whatever its name; so is the body, the part with the largest
///   area times bones that does not lie over others;
/// - over another part along its normals, for half of its area, or for a quarter if its name is a garment's: cloth; so
///   are hair, beards and brows near the skin;
/// - small and inside of the others, or named as an eye, a tooth, a tongue: rigid.
[[nodiscard]] std::vector<SkinLayer> guessLayers(const Character& character);

}  // namespace sinew
