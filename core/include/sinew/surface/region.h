// core/include/sinew/surface/region.h: the control triangles to smooth in detail if not the whole body.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/character/character.h"

namespace sinew {

/// [T] 1: in detail. Empty: the whole body. docs/games.md, A part of the body.
using Region = std::vector<std::uint8_t>;

/// The skin of these bones and of all below them: triangles with a corner that follows them by half or more.
/// @param bones  indices into Skeleton::bones
[[nodiscard]] Region regionOfBones(const Character& character, std::span<const int> bones);

/// @param parts  indices into Character::parts
[[nodiscard]] Region regionOfParts(const Character& character, std::span<const int> parts);

}  // namespace sinew
