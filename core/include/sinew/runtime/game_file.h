// core/include/sinew/runtime/game_file.h: a character with its rig as a game loads them: binary, from memory.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// What a Smoother needs. Of materials the names are there, and no textures: a game has its own.
struct GameCharacter {
  std::shared_ptr<const Character> character;
  Rig rig;
};

/// Bytes of a game file (docs/games.md): the same for the same character and rig.
[[nodiscard]] std::vector<std::byte> gameFile(const Character& character, const Rig& rig);

/// Reads one that lies in memory. Untrusted input: counts are checked before anything is allocated, and all numbers
/// and indices before they are used. The surface is, bit for bit, that of the character and the rig it was made from.
/// Error: place and reason, without a file. Never throws but for want of memory.
[[nodiscard]] Result<GameCharacter> readGameFile(std::span<const std::byte> bytes);

}  // namespace sinew
