// core/geometry/nearest_name.h: the name that a misspelled word was probably meant as.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

// Names as a sentence has them.

/// "a, b or c" @param word  before the last: "or", "and"
[[nodiscard]] inline std::string listed(const std::vector<std::string>& names, std::string_view word) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : ' ' + std::string(word) + ' ';
    text += names[i];
  }
  return text;
}

// Small letters for capitals, ASCII alone: bytes of other letters stay what they are.

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

/// The name nearest to the word: capitals and signs do not count, up to a third of the letters may be wrong, missing or
/// swapped; else one that has the word as a part. "" where none is near.
[[nodiscard]] std::string nearestName(std::string_view word, const std::vector<std::string>& names);

/// `; did you mean "Walk"?`, or "" where no name is near.
[[nodiscard]] std::string didYouMean(std::string_view word, const std::vector<std::string>& names);

}  // namespace sinew
