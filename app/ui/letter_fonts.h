// app/ui/letter_fonts.h: in which font files letters are looked for, in what order.
#pragma once

#include <string_view>
#include <vector>

namespace sinew::app {

struct FontFile {
  std::string_view file;
  int face = 0;  ///< Of those in the file.
  bool operator==(const FontFile&) const = default;
};

/// Where a Chinese letter comes from: one code point has another form in each.
enum class HanRegion { kJapan, kKorea, kMainland, kTaiwan, kHongKong };

/// What the names of a document say: kana means Japan, hangul Korea. Else the user's language ("ja_JP.UTF-8"), else
/// mainland China.
[[nodiscard]] HanRegion hanRegion(std::u32string_view letters, std::string_view locale);
/// The language of the environment: the first of LC_ALL, LC_CTYPE, LANG that is set, or "".
[[nodiscard]] std::string_view localeOfEnvironment();

/// Files of Debian's packages that may have a letter, best first; any may be missing. @param strong  for headings
[[nodiscard]] std::vector<FontFile> fontFilesFor(char32_t c, bool strong, HanRegion region);

/// Height of the em square in pixels, beside an interface font of a height: Chinese letters fill theirs, so that
/// theirs is a little larger than that of Latin letters and still fits into the line.
[[nodiscard]] int wideEm(float fontSize);

}  // namespace sinew::app
