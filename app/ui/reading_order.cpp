// app/ui/reading_order.cpp: the Unicode bidirectional algorithm and Arabic joining, by FriBidi.

#include "app/ui/reading_order.h"

#include <fribidi.h>

#include <algorithm>
#include <set>
#include <vector>

#include "app/ui/code_points.h"

namespace sinew::app {
namespace {

constexpr char32_t kFromLeft = 0x202D;    ///< What follows is in the order of the screen ...
constexpr char32_t kEndOfOrder = 0x202C;  ///< ... up to here.

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
    if (!isInvisible(letter)) out.push_back(letter);  // Marks, and what ligatures leave behind.
  }
  out.push_back(kEndOfOrder);
  return out;
}

/// Looked at in every frame for every label: without decoding it.
bool isAscii(const std::string& text) {
  return std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) >= 0x80u; });
}

std::set<char32_t>& shownLetters() {
  static std::set<char32_t> letters;
  return letters;
}

/// The same text where nothing of it is read from the right.
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
