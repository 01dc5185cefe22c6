// core/geometry/grouped.h: counts for people.
#pragma once

#include <cstddef>
#include <string>

namespace sinew {

/// 12345 -> "12,345".
[[nodiscard]] inline std::string grouped(long long number) {
  const std::string digits = std::to_string(number < 0 ? -number : number);
  std::string out = number < 0 ? "-" : "";
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

}  // namespace sinew
