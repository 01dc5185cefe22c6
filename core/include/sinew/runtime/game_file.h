// core/include/sinew/runtime/game_file.h: a character with its rig in a binary file for games.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Everything a Smoother needs. Materials have only names, and there are no textures, since games have their own.
struct GameCharacter {
  std::shared_ptr<const Character> character;
  Rig rig;
};

/// Bytes of a game file (docs/games.md): the same for the same character and rig.
[[nodiscard]] std::vector<std::byte> gameFile(const Character& character, const Rig& rig);

/// Reads a game file from memory. Untrusted input: counts are checked before allocation, and all numbers and indices
/// before use. The surface is bit for bit that of the original character and rig. Error: place and reason, without a
/// file. Only throws if there is not enough memory.
[[nodiscard]] Result<GameCharacter> readGameFile(std::span<const std::byte> bytes);

}  // namespace sinew
