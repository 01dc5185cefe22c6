// core/files/gltf/glb.cpp: splitting a GLB container (glTF 2.0, section 4.4).

#include "core/files/gltf/glb.h"

namespace sinew::gltf {
namespace {

constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

std::string_view textOf(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

std::uint32_t littleEndian(Bytes bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(bytes[offset + i]) << (8 * i);
  return value;
}

/// Header of 12 bytes, then chunks of length, type, data.
Container split(Bytes file) {
  if (file.size() < 12) refuse("byte " + std::to_string(file.size()), "the file ends within the GLB header");
  if (littleEndian(file, 4) != 2)
    refuse("byte 4", "GLB version " + std::to_string(littleEndian(file, 4)) + "; 2 expected");
  const std::size_t length = littleEndian(file, 8);
  if (length > file.size()) {
    refuse("byte " + std::to_string(file.size()),
           "the file is cut off: its header promises " + std::to_string(length) + " bytes", "damaged");
  }
  Container result;
  for (std::size_t at = 12; at + 8 <= length;) {
    const std::size_t size = littleEndian(file, at);
    const std::uint32_t type = littleEndian(file, at + 4);
    if (size > length - at - 8) refuse("byte " + std::to_string(at), "a GLB chunk reaches beyond the end of the file");
    const Bytes chunk = file.subspan(at + 8, size);
    if (at == 12 && type != kJsonChunk) refuse("byte 16", "the first GLB chunk must be JSON");
    if (type == kJsonChunk && at == 12) result.json = textOf(chunk);
    if (type == kBinaryChunk && !result.binary) result.binary = chunk;
    at += 8 + size;
  }
  // Some exporters pad with zeros instead of spaces.
  while (!result.json.empty() && result.json.back() == '\0') result.json.remove_suffix(1);
  if (result.json.empty()) refuse("byte 12", "a GLB without a JSON chunk");
  return result;
}

}  // namespace

Container openContainer(Bytes file) {
  if (file.empty()) refuse("", "the file is empty");
  return textOf(file).starts_with("glTF") ? split(file) : Container{.json = textOf(file), .binary = {}};
}

}  // namespace sinew::gltf
