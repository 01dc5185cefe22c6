// core/runtime/game_file.cpp: game files read and written.

#include "core/runtime/game_file.h"
#include "core/geometry/normals.h"
#include "core/geometry/weld.h"
#include "core/rig/validation.h"
#include "core/runtime/layout.h"
#include "sinew/runtime/game_file.h"

namespace sinew {
namespace {

using gamefile::Head;

/// The bytes after the head.
Result<std::span<const std::byte>> gameBytes(std::span<const std::byte> file) {
  Head head;
  if (file.size() < sizeof head) return errorAt("byte 0", "this is not a Sinew game file: it is too short");
  std::memcpy(&head, file.data(), sizeof head);
  if (head.magic != gamefile::kMagic) return errorAt("byte 0", "this is not a Sinew game file");
  if (head.version != gamefile::kVersion) {
    return errorAt("byte 8", "expected version " + std::to_string(gamefile::kVersion) + ", got " +
                                 std::to_string(head.version) + ": export the character again");
  }
  const auto rest = file.subspan(sizeof head);
  if (head.bytes != rest.size()) {
    return errorAt("byte 16", "the file should have " + std::to_string(head.bytes) + " bytes after its head, it has " +
                                  std::to_string(rest.size()));
  }
  if (head.sum != gamefile::sumOf(rest)) return errorAt("byte 24", "the file is damaged: its checksum does not match");
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
