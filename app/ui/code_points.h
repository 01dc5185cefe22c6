// app/ui/code_points.h: text as code points, their properties, and readable names.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "sinew/rig/rig.h"

namespace sinew::app {

// Replacements for names that no installed font can show.

using HasGlyph = std::function<bool(char32_t)>;  ///< Whether a font has a glyph for a code point.

/// The name with `instead` ("bone 12") in place of the first letters without a glyph; further ones are dropped: without
/// a Japanese font the left arm's bone is "bone 12.L".
[[nodiscard]] std::string readable(const std::string& name, const std::string& instead, const HasGlyph& hasGlyph);

void setGlyphs(HasGlyph hasGlyph);  ///< Of the interface's fonts. By default (command line) every glyph exists.
/// readable() with these glyphs and "word number".
[[nodiscard]] std::string readableName(const std::string& name, const char* word, int number);

/// Muscles, groups and morph targets in lists; counted from 1. A belly has the name of its sheet.
[[nodiscard]] std::string shownMuscleName(const Rig& rig, int primitive);
[[nodiscard]] std::string shownGroupName(const Rig& rig, int group);
[[nodiscard]] std::string shownMorphName(const Rig& rig, int morph);

[[nodiscard]] bool isAscii(std::string_view text);
[[nodiscard]] std::u32string codePoints(std::string_view text);  ///< From UTF-8; each ill-formed byte becomes U+FFFD.
[[nodiscard]] std::string utf8(std::u32string_view text);

[[nodiscard]] bool isInvisible(char32_t c);  ///< Joiners, marks of direction, variation selectors.
[[nodiscard]] bool isWide(char32_t c);       ///< Chinese, Japanese and Korean letters and signs, drawn in a square.
[[nodiscard]] bool isKana(char32_t c);
[[nodiscard]] bool isHangul(char32_t c);
[[nodiscard]] bool isRightToLeft(char32_t c);  ///< Hebrew, Arabic and related scripts, with the joined forms of Arabic.
[[nodiscard]] bool isJoinedForm(char32_t c);   ///< Joined forms of Arabic letters.

}  // namespace sinew::app
