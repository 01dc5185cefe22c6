// core/files/gltf/image_bytes.h: kinds of image files, told by how they begin.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>

namespace sinew {

[[nodiscard]] inline bool startsWith(std::span<const std::uint8_t> bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin(),
                                                    [](char a, auto b) { return static_cast<std::uint8_t>(a) == b; });
}

[[nodiscard]] inline bool isWebp(std::span<const std::uint8_t> bytes) {
  return bytes.size() > 8 && startsWith(bytes, "RIFF") && startsWith(bytes.subspan(8), "WEBP");
}

/// ".png" or ".jpg"; "" for others.
[[nodiscard]] inline std::string_view imageEnding(std::span<const std::uint8_t> bytes) {
  return startsWith(bytes, "\x89PNG") ? ".png" : startsWith(bytes, "\xff\xd8\xff") ? ".jpg" : "";
}

}  // namespace sinew
