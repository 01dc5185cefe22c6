// app/ui/code_points.h: text as code points, and what the interface has to know about one.
#pragma once

#include <string>
#include <string_view>

namespace sinew::app {

/// UTF-8 -> code points; what is ill-formed becomes U+FFFD, a byte at a time.
[[nodiscard]] std::u32string codePoints(std::string_view text);
/// The reverse.
[[nodiscard]] std::string utf8(std::u32string_view text);

/// Takes no room and shows nothing: joiners, marks of direction, variation selectors.
[[nodiscard]] bool isInvisible(char32_t c);
/// Chinese, Japanese and Korean letters and signs, drawn in a square of the height of a line.
[[nodiscard]] bool isWide(char32_t c);
[[nodiscard]] bool isKana(char32_t c);
[[nodiscard]] bool isHangul(char32_t c);
/// Hebrew, Arabic and their neighbours, with the joined forms of Arabic.
[[nodiscard]] bool isRightToLeft(char32_t c);
/// Arabic letters in the form they have beside others: such touch the next.
[[nodiscard]] bool isJoinedForm(char32_t c);

}  // namespace sinew::app
