// core/include/sinew/runtime/game_file.h: a character with its rig in the binary format that games load from memory.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// The input of a Smoother. Materials have only names, and there are no textures: a game has its own.
struct GameCharacter {
  std::shared_ptr<const Character> character;
  Rig rig;
};

/// The bytes of a game file (docs/games.md): the same for the same character and rig.
[[nodiscard]] std::vector<std::byte> gameFile(const Character& character, const Rig& rig);

/// Reads a game file in memory. Input is untrusted: counts are checked before anything is allocated, and all numbers
/// and indices before they are used. The surface is, to the bit, that of the original character and rig. Error: place
/// and reason, without a file. Throws only if memory runs out.
[[nodiscard]] Result<GameCharacter> readGameFile(std::span<const std::byte> bytes);

}  // namespace sinew
