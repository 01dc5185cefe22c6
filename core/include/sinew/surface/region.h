// core/include/sinew/surface/region.h: control triangles to smooth in detail instead of the whole body.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/character/character.h"

namespace sinew {

/// [T] 1: in detail. Empty: the whole body. docs/games.md, A part of the body.
using Region = std::vector<std::uint8_t>;

/// The skin of these bones and all below them: triangles with a corner that has at least half of its weight on them.
/// @param bones  indices into Skeleton::bones
[[nodiscard]] Region regionOfBones(const Character& character, std::span<const int> bones);

/// @param parts  indices into Character::parts
[[nodiscard]] Region regionOfParts(const Character& character, std::span<const int> parts);

}  // namespace sinew
