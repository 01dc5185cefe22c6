// core/geometry/listed.h: names as a sentence has them.
#pragma once

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

}  // namespace sinew
