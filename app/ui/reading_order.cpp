// app/ui/reading_order.cpp: eliding; the Unicode bidirectional algorithm and Arabic joining by FriBidi.
#include "app/ui/reading_order.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <fribidi.h>

#include "app/ui/code_points.h"

namespace sinew::app {

namespace {

constexpr const char* kEllipsis = "...";
constexpr std::string_view kSeparators = "_:.-| /";
constexpr float kHead = 0.4f;  ///< Fraction of the room; the rest is for the end, where most names differ.

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

/// Starts of characters, and the end.
std::vector<std::size_t> boundaries(std::string_view text) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == 0 || !isContinuation(text[i])) places.push_back(i);
  }
  places.push_back(text.size());
  return places;
}

/// The longest beginning that fits, as an index into `places`.
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

/// The longest end that fits and starts at or after `from`, as an index into `places`.
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
  // Joined pieces may be wider than their sum: then take less of both.
  for (float part = room; part > 0.0f; part -= 0.05f * room) {
    const std::size_t head = headThatFits(text, places, kHead * part, measure);
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
  // Prefers to show the beginning if there is room.
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

namespace {

constexpr char32_t kFromLeft = 0x202D;    ///< Begins text in visual order ...
constexpr char32_t kEndOfOrder = 0x202C;  ///< ... and ends it.

std::u32string lineInOrder(std::u32string_view line) {
  const auto length = static_cast<FriBidiStrIndex>(line.size());
  std::vector<FriBidiChar> letters(line.begin(), line.end());
  std::vector<FriBidiCharType> types(line.size());
  std::vector<FriBidiBracketType> brackets(line.size());
  std::vector<FriBidiLevel> levels(line.size());
  std::vector<FriBidiArabicProp> joins(line.size());
  fribidi_get_bidi_types(letters.data(), length, types.data());
  fribidi_get_bracket_types(letters.data(), length, types.data(), brackets.data());
  FriBidiParType direction = FRIBIDI_PAR_LTR;
  if (fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), length, &direction, levels.data()) == 0)
    return std::u32string(line);
  fribidi_get_joining_types(letters.data(), length, joins.data());
  fribidi_join_arabic(types.data(), length, levels.data(), joins.data());
  fribidi_shape(FRIBIDI_FLAGS_DEFAULT | FRIBIDI_FLAGS_ARABIC, levels.data(), length, joins.data(), letters.data());
  if (fribidi_reorder_line(FRIBIDI_FLAGS_DEFAULT, types.data(), length, 0, direction, levels.data(), letters.data(),
                           nullptr) == 0) {
    return std::u32string(line);
  }
  std::u32string out{kFromLeft};
  for (const FriBidiChar letter : letters) {
    if (!isInvisible(letter)) out.push_back(letter);  // Drops marks and remains of ligatures.
  }
  out.push_back(kEndOfOrder);
  return out;
}

std::set<char32_t>& shownLetters() {
  static std::set<char32_t> letters;
  return letters;
}

/// Unchanged without right-to-left letters.
std::u32string lettersInOrder(const std::u32string& letters) {
  if (std::ranges::none_of(letters, isRightToLeft)) return letters;
  std::u32string out;
  for (std::size_t from = 0; from <= letters.size();) {
    const std::size_t end = std::min(letters.find(U'\n', from), letters.size());
    const std::u32string_view line = std::u32string_view(letters).substr(from, end - from);
    const bool done = line.find(kFromLeft) != line.npos || std::ranges::none_of(line, isRightToLeft);
    out += done ? std::u32string(line) : lineInOrder(line);
    if (end < letters.size()) out.push_back(U'\n');
    from = end + 1;
  }
  return out;
}

}  // namespace

std::string inReadingOrder(const std::string& text) {
  if (isAscii(text)) return text;
  const std::u32string letters = codePoints(text);
  const std::u32string out = lettersInOrder(letters);
  noteShown(out);
  return out == letters ? text : utf8(out);
}

void noteShown(std::u32string_view letters) {
  for (const char32_t c : letters) {
    if (c >= 0x80) shownLetters().insert(c);
  }
}

std::u32string takeShown() {
  std::u32string letters(shownLetters().begin(), shownLetters().end());
  shownLetters().clear();
  return letters;
}

}  // namespace sinew::app
