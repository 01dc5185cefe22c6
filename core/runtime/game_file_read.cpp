// core/runtime/game_file_read.cpp: bytes -> character and rig, with all that follows from them.
#include "core/geometry/normals.h"
#include "core/geometry/weld.h"
#include "core/rig/validation.h"
#include "core/runtime/game_check.h"
#include "core/runtime/game_file.h"
#include "core/runtime/layout.h"
#include "sinew/runtime/game_file.h"

namespace sinew {
namespace {

using gamefile::Head;

/// What follows the head.
Result<std::span<const std::byte>> gameBytes(std::span<const std::byte> file) {
  Head head;
  if (file.size() < sizeof head) return errorAt("byte 0", "this is no game file of Sinew: it is too short");
  std::memcpy(&head, file.data(), sizeof head);
  if (head.magic != gamefile::kMagic) return errorAt("byte 0", "this is no game file of Sinew");
  if (head.version != gamefile::kVersion) {
    return errorAt("byte 8", "expected version " + std::to_string(gamefile::kVersion) + ", got " +
                                 std::to_string(head.version) + ": export the character again");
  }
  const auto rest = file.subspan(sizeof head);
  if (head.bytes != rest.size()) {
    return errorAt("byte 16", "the file should have " + std::to_string(head.bytes) + " bytes after its head, it has " +
                                  std::to_string(rest.size()));
  }
  if (head.sum != gamefile::sumOf(rest)) return errorAt("byte 24", "the file is damaged: its sum is another");
  return rest;
}

}  // namespace

Result<GameCharacter> readGameFile(std::span<const std::byte> bytes) {
  const auto rest = gameBytes(bytes);
  if (!rest) return rest.error();
  auto character = std::make_shared<Character>();
  Rig rig;
  gamefile::Reader reader(rest.value());
  fields(reader, *character);
  fields(reader, rig);
  if (!reader.failed() && reader.left() > 0) reader.refuse("expected the end of the file");
  if (reader.failed()) return reader.error();
  if (Result<void> sound = gamefile::checkCharacter(*character); !sound) return sound.error();
  findEdges(character->mesh);
  character->mesh.normals = vertexNormals(character->mesh.positions, character->mesh.triangles);
  if (Result<void> valid = validate(rig); !valid) return valid.error();
  return GameCharacter{std::move(character), std::move(rig)};
}

}  // namespace sinew
