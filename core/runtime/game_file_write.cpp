// core/runtime/game_file_write.cpp: character and rig -> bytes.
#include <algorithm>

#include "core/runtime/game_file.h"
#include "core/runtime/layout.h"
#include "sinew/runtime/game_file.h"

namespace sinew {

std::vector<std::byte> gameFile(const Character& character, const Rig& rig) {
  gamefile::Writer writer;
  writer.bytes().resize(sizeof(gamefile::Head));
  fields(writer, character);
  fields(writer, rig);
  std::vector<std::byte> bytes = std::move(writer.bytes());
  const auto rest = std::span<const std::byte>(bytes).subspan(sizeof(gamefile::Head));
  gamefile::Head head;
  head.bytes = rest.size();
  head.sum = gamefile::sumOf(rest);
  std::memcpy(bytes.data(), &head, sizeof head);
  return bytes;
}

}  // namespace sinew
