// core/geometry/nearest_name.cpp: edit distances of what is left of names without signs.
#include "core/geometry/nearest_name.h"

#include <algorithm>
#include <cstddef>

namespace sinew {
namespace {

constexpr std::size_t kLeastPart = 3;      ///< Shortest word to look for inside names.
constexpr std::size_t kLongestWord = 256;  ///< The distance is quadratic.

/// "Upper_Arm.L" -> "upperarml"; bytes beyond ASCII are kept.
std::string keptLetters(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    const char lower = toLower(c);
    const bool isLetter = (lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9');
    if (isLetter || static_cast<unsigned char>(lower) >= 0x80U) letters += lower;
  }
  return letters;
}

/// Number of letters that are wrong, missing, too many, or swapped with their neighbour.
std::size_t editsBetween(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({changed, last[j] + 1, now[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, now);
  }
  return last[b.size()];
}

}  // namespace

std::string nearestName(std::string_view word, const std::vector<std::string>& names) {
  const std::string wanted = keptLetters(word);
  if (wanted.empty() || wanted.size() > kLongestWord) return {};
  const std::size_t most = std::max<std::size_t>(wanted.size() / 3, 1);
  std::size_t least = most + 1;
  const std::string* nearest = nullptr;
  const std::string* holder = nullptr;
  for (const std::string& name : names) {
    const std::string letters = keptLetters(name);
    if (wanted.size() >= kLeastPart && letters.find(wanted) != std::string::npos &&
        (holder == nullptr || name.size() < holder->size())) {
      holder = &name;
    }
    if (letters.empty() || letters.size() > wanted.size() + most) continue;
    const std::size_t edits = editsBetween(wanted, letters);
    // At least one letter must be right.
    if (edits >= least || edits >= std::max(wanted.size(), letters.size())) continue;
    least = edits;
    nearest = &name;
  }
  if (nearest == nullptr) nearest = holder;
  return nearest == nullptr ? std::string() : *nearest;
}

std::string didYouMean(std::string_view word, const std::vector<std::string>& names) {
  const std::string name = nearestName(word, names);
  return name.empty() ? std::string() : "; did you mean \"" + name + "\"?";
}

}  // namespace sinew
