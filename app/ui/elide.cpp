// app/ui/elide.cpp: long names in little room, so that names that differ stay different.

#include "app/ui/elide.h"

#include <map>
#include <vector>

namespace sinew::app {
namespace {

constexpr const char* kEllipsis = "...";
constexpr std::string_view kSeparators = "_:.-| /";
constexpr float kHeadShare = 0.4f;  ///< Share of the room; the rest is for the end, where names differ most often.

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

/// Where characters begin, and the end.
std::vector<std::size_t> boundaries(std::string_view text) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == 0 || !isContinuation(text[i])) places.push_back(i);
  }
  places.push_back(text.size());
  return places;
}

/// The most characters from the front that fit; an index into the boundaries.
std::size_t headThatFits(std::string_view text, const std::vector<std::size_t>& places, float room,
                         const MeasureText& measure) {
  std::size_t low = 0;
  std::size_t high = places.size() - 1;
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (measure(text.substr(0, places[middle])) <= room) low = middle;
    else high = middle - 1;
  }
  return low;
}

/// The longest end that fits and begins no earlier than `from`; an index into the boundaries.
std::size_t tailThatFits(std::string_view text, const std::vector<std::size_t>& places, std::size_t from, float room,
                         const MeasureText& measure) {
  std::size_t low = from;
  std::size_t high = places.size() - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (measure(text.substr(places[middle])) <= room) high = middle;
    else low = middle + 1;
  }
  return low;
}

std::string inTheMiddle(std::string_view text, float width, const MeasureText& measure) {
  const float room = width - measure(kEllipsis);
  const std::vector<std::size_t> places = boundaries(text);
  // Measured apart, two pieces may be narrower than together: then less of both.
  for (float part = room; part > 0.0f; part -= 0.05f * room) {
    const std::size_t head = headThatFits(text, places, kHeadShare * part, measure);
    const float headWidth = measure(text.substr(0, places[head]));
    const std::size_t tail = tailThatFits(text, places, head, part - headWidth, measure);
    const std::string shown =
        std::string(text.substr(0, places[head])) + kEllipsis + std::string(text.substr(places[tail]));
    if (measure(shown) <= width) return shown;
  }
  return kEllipsis;
}

/// The longest of the pieces that more than half of `count` names have.
std::string_view longestOfMost(const std::map<std::string_view, std::size_t>& pieces, std::size_t count) {
  std::string_view longest;
  for (const auto& [piece, times] : pieces) {
    if (2 * times > count && piece.size() > longest.size()) longest = piece;
  }
  return longest;
}

bool isSeparator(char c) { return kSeparators.find(c) != std::string_view::npos; }

}  // namespace

SharedEnds sharedEnds(std::span<const std::string_view> names) {
  if (names.size() < 2) return {};
  std::map<std::string_view, std::size_t> prefixes;
  std::map<std::string_view, std::size_t> suffixes;
  for (const std::string_view name : names) {
    for (std::size_t i = 0; i < name.size(); ++i) {
      if (!isSeparator(name[i])) continue;
      if (i + 1 < name.size()) ++prefixes[name.substr(0, i + 1)];
      if (i > 0) ++suffixes[name.substr(i)];
    }
  }
  return {longestOfMost(prefixes, names.size()), longestOfMost(suffixes, names.size())};
}

std::string elided(const std::string& text, float width, const MeasureText& measure, const SharedEnds& shared) {
  if (measure(text) <= width) return text;
  if (measure(kEllipsis) >= width) return kEllipsis;
  std::string_view core = text;
  if (core.starts_with(shared.prefix) && core.size() > shared.prefix.size()) core.remove_prefix(shared.prefix.size());
  const bool begun = core.size() < text.size();
  // Room for the beginning as well is used for it.
  const std::string both = begun ? inTheMiddle(text, width, measure) : std::string();
  const std::size_t gap = both.find(kEllipsis);
  if (gap != std::string::npos && both.size() - gap - std::string_view(kEllipsis).size() >= core.size()) return both;
  const std::string withEnd = (begun ? kEllipsis : "") + std::string(core);
  if (begun && measure(withEnd) <= width) return withEnd;
  const std::string_view whole = core;
  if (core.ends_with(shared.suffix) && core.size() > shared.suffix.size()) core.remove_suffix(shared.suffix.size());
  const std::string between = (begun ? kEllipsis : "") + std::string(core) + kEllipsis;
  if (core.size() < whole.size() && measure(between) <= width) return between;
  return inTheMiddle(core, width, measure);
}

}  // namespace sinew::app
