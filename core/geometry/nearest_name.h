// core/geometry/nearest_name.h: the name probably meant by a misspelled word; lists and cases of words.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// "a, b or c" @param word  before the last: "or", "and"
[[nodiscard]] inline std::string listed(const std::vector<std::string>& names, std::string_view word) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : ' ' + std::string(word) + ' ';
    text += names[i];
  }
  return text;
}

// Lower case for ASCII; bytes of other letters are kept.

[[nodiscard]] constexpr char toLower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

[[nodiscard]] inline std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(text, lower.begin(), toLower);
  return lower;
}

/// "OUT.GLB" -> ".glb".
[[nodiscard]] inline std::string lowerEnding(const std::filesystem::path& file) {
  return lowerCase(file.extension().string());
}

/// The name nearest to the word, ignoring case and punctuation, with up to a third of the letters wrong, missing or
/// swapped; else one that contains the word. "": none is near.
[[nodiscard]] std::string nearestName(std::string_view word, const std::vector<std::string>& names);

/// `; did you mean "Walk"?`, or "" if no name is near.
[[nodiscard]] std::string didYouMean(std::string_view word, const std::vector<std::string>& names);

}  // namespace sinew
