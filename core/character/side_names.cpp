// core/character/side_names.cpp: words in names, and the sides they mean.
#include "core/character/side_names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/geometry/lower_case.h"

namespace sinew {
namespace {

struct MarkerPair {
  std::string_view left;
  std::string_view right;
};

constexpr MarkerPair kWords{"left", "right"};
constexpr std::array<MarkerPair, 4> kShort{MarkerPair{"l", "r"}, MarkerPair{"lf", "rt"}, MarkerPair{"fl", "fr"},
                                           MarkerPair{"bl", "br"}};

bool isUpperLetter(char c) { return c >= 'A' && c <= 'Z'; }
bool isLower(char c) { return c >= 'a' && c <= 'z'; }
bool isAnyLetter(char c) { return isUpperLetter(c) || isLower(c); }

/// A new word begins at `at`: after anything but a letter, at a capital after a small letter, and at the last capital
/// of a run that a small letter follows ("LArm": L, Arm).
bool beginsWord(std::string_view name, std::size_t at) {
  if (at == 0 || !isAnyLetter(name[at - 1])) return true;
  if (!isUpperLetter(name[at])) return false;
  return isLower(name[at - 1]) || (at + 1 < name.size() && isLower(name[at + 1]));
}

/// Letters of any script that are not ASCII belong to the word they touch.
bool isForeign(std::string_view name, std::size_t at) {
  return at < name.size() && (static_cast<unsigned char>(name[at]) & 0x80u) != 0;
}

/// "bright", "upright" and "cleft" say nothing of a side: within a word at least three letters must stand before.
bool staysApart(std::string_view name, std::size_t at) {
  std::size_t begin = at;
  while (begin > 0 && !beginsWord(name, begin)) --begin;
  return begin == at || at - begin >= 3;
}

void addWholeWords(std::string_view name, const std::string& lower, std::vector<SideMarker>& markers) {
  for (const auto& [text, side] : {std::pair{kWords.left, Side::kLeft}, std::pair{kWords.right, Side::kRight}}) {
    for (std::size_t at = lower.find(text); at != std::string::npos; at = lower.find(text, at + text.size())) {
      if (staysApart(name, at)) markers.push_back({at, text.size(), side});
    }
  }
  std::ranges::sort(markers, {}, &SideMarker::begin);
}

void addShort(std::string_view name, const std::string& lower, std::vector<SideMarker>& markers) {
  for (std::size_t begin = 0; begin < name.size(); ++begin) {
    if (!isAnyLetter(name[begin]) || !beginsWord(name, begin) || (begin > 0 && isForeign(name, begin - 1))) continue;
    std::size_t end = begin + 1;
    while (end < name.size() && isAnyLetter(name[end]) && !beginsWord(name, end)) ++end;
    if (isForeign(name, end)) continue;
    const std::string_view word = std::string_view(lower).substr(begin, end - begin);
    for (const MarkerPair& pair : kShort) {
      if (word == pair.left) markers.push_back({begin, end - begin, Side::kLeft});
      if (word == pair.right) markers.push_back({begin, end - begin, Side::kRight});
    }
  }
}

/// `text` written as `like` is: all capitals, a leading capital, or small.
std::string inCaseOf(std::string_view text, std::string_view like) {
  std::string result(text);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const bool upper = i == 0 ? isUpperLetter(like[0]) : isUpperLetter(like[std::min(i, like.size() - 1)]);
    if (upper) result[i] = static_cast<char>(result[i] - 'a' + 'A');
  }
  return result;
}

std::string_view opposite(std::string_view lowerMarker) {
  const auto of = [&](const MarkerPair& pair) {
    return lowerMarker == pair.left ? pair.right : (lowerMarker == pair.right ? pair.left : std::string_view());
  };
  if (const std::string_view word = of(kWords); !word.empty()) return word;
  for (const MarkerPair& pair : kShort) {
    if (const std::string_view text = of(pair); !text.empty()) return text;
  }
  return lowerMarker;
}

}  // namespace

std::vector<SideMarker> sideMarkers(std::string_view name) {
  const std::string lower = lowerCase(name);
  std::vector<SideMarker> markers;
  addWholeWords(name, lower, markers);
  if (markers.empty()) addShort(name, lower, markers);
  return markers;
}

std::optional<Side> sideNamed(std::string_view name) {
  const std::vector<SideMarker> markers = sideMarkers(name);
  const auto left = std::ranges::count(markers, Side::kLeft, &SideMarker::side);
  const auto right = std::ranges::count(markers, Side::kRight, &SideMarker::side);
  if (left == right) return std::nullopt;
  return left > right ? Side::kLeft : Side::kRight;
}

std::string withoutSide(const std::string& name) {
  const std::vector<SideMarker> markers = sideMarkers(name);
  if (markers.size() != 1) return name;
  std::string text = name;
  text.erase(markers[0].begin, markers[0].length);
  const auto parts = [](char c) { return c == ' ' || c == '.' || c == '_' || c == '-'; };
  while (!text.empty() && parts(text.back())) text.pop_back();
  while (!text.empty() && parts(text.front())) text.erase(0, 1);
  return text.empty() ? name : text;
}

std::optional<std::string> mirroredName(std::string_view name) {
  const std::vector<SideMarker> markers = sideMarkers(name);
  if (markers.size() != 1) return std::nullopt;
  const std::string_view marker = name.substr(markers[0].begin, markers[0].length);
  std::string result(name.substr(0, markers[0].begin));
  result += inCaseOf(opposite(lowerCase(marker)), marker);
  result += name.substr(markers[0].begin + markers[0].length);
  return result;
}

}  // namespace sinew
