// core/geometry/lower_case.h: small letters for capitals, ASCII alone: bytes of other letters stay what they are.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

namespace sinew {

[[nodiscard]] constexpr char toLower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

[[nodiscard]] inline std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(text, lower.begin(), toLower);
  return lower;
}

/// ".glb" of "OUT.GLB".
[[nodiscard]] inline std::string lowerEnding(const std::filesystem::path& file) {
  return lowerCase(file.extension().string());
}

}  // namespace sinew
