// app/ui/code_points.cpp: UTF-8, blocks of Unicode, and names without glyphs.
#include "app/ui/code_points.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include "core/geometry/at.h"

namespace sinew::app {

namespace {

/// Set once when the window opens.
HasGlyph& glyphsOfInterface() {
  static HasGlyph glyphs;
  return glyphs;
}

}  // namespace

std::string readable(const std::string& name, const std::string& instead, const HasGlyph& hasGlyph) {
  if (!hasGlyph || isAscii(name)) return name;
  const std::u32string letters = codePoints(name);
  const auto missing = [&](char32_t c) { return !isInvisible(c) && c >= 0x80 && !hasGlyph(c); };
  if (std::ranges::none_of(letters, missing)) return name;
  std::string out;
  bool said = false;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    if (!missing(letters[i])) {
      out += utf8(std::u32string_view(letters).substr(i, 1));
      continue;
    }
    if (!said) out += instead;
    said = true;
  }
  return out;
}

void setGlyphs(HasGlyph hasGlyph) { glyphsOfInterface() = std::move(hasGlyph); }

std::string readableName(const std::string& name, const char* word, int number) {
  if (!glyphsOfInterface() || isAscii(name)) return name;
  return readable(name, std::string(word) + ' ' + std::to_string(number), glyphsOfInterface());
}

std::string shownMuscleName(const Rig& rig, int primitive) {
  const Primitive& muscle = at(rig.primitives, primitive);
  return readableName(muscle.sheet.empty() ? muscle.name : muscle.sheet, "muscle", primitive + 1);
}

std::string shownGroupName(const Rig& rig, int group) {
  return readableName(at(rig.groups, group).name, "group", group + 1);
}

std::string shownMorphName(const Rig& rig, int morph) {
  return readableName(at(rig.morphs, morph).name, "shape", morph + 1);
}

namespace {

constexpr char32_t kReplacement = 0xFFFD;

struct LetterBlock {
  char32_t first;
  char32_t last;
};

bool isInBlocks(char32_t c, std::span<const LetterBlock> blocks) {
  return std::ranges::any_of(blocks, [&](const LetterBlock& block) { return c >= block.first && c <= block.last; });
}

unsigned byteAt(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

/// Length by the first byte; 0: invalid.
std::size_t sequenceLength(unsigned first) {
  if (first < 0x80u) return 1;
  if (first >= 0xC2u && first < 0xE0u) return 2;
  if (first >= 0xE0u && first < 0xF0u) return 3;
  return first >= 0xF0u && first < 0xF5u ? 4 : 0;
}

bool isScalar(char32_t c, std::size_t length) {
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  return c >= kLeast[length] && c <= 0x10FFFF && (c < 0xD800 || c > 0xDFFF);
}

}  // namespace

bool isAscii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80u; });
}

std::u32string codePoints(std::string_view text) {
  std::u32string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequenceLength(byteAt(text, i));
    bool whole = length > 0 && i + length <= text.size();
    char32_t c = whole ? byteAt(text, i) & (length == 1 ? 0x7Fu : 0xFFu >> (length + 1)) : 0u;
    for (std::size_t k = 1; whole && k < length; ++k) {
      whole = (byteAt(text, i + k) & 0xC0u) == 0x80u;
      c = (c << 6) | (byteAt(text, i + k) & 0x3Fu);
    }
    whole = whole && isScalar(c, length);
    out.push_back(whole ? c : kReplacement);
    i += whole ? length : 1;
  }
  return out;
}

std::string utf8(std::u32string_view text) {
  std::string out;
  const auto put = [&](char32_t byte) { out.push_back(static_cast<char>(static_cast<unsigned char>(byte))); };
  for (const char32_t c : text) {
    if (c < 0x80) {
      put(c);
      continue;
    }
    const int rest = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    constexpr char32_t kFirst[] = {0, 0xC0, 0xE0, 0xF0};
    put(kFirst[rest] | (c >> (6 * rest)));
    for (int k = rest - 1; k >= 0; --k) put(0x80u | ((c >> (6 * k)) & 0x3Fu));
  }
  return out;
}

bool isInvisible(char32_t c) {
  constexpr LetterBlock kBlocks[] = {{0xAD, 0xAD},     {0x61C, 0x61C},   {0x200B, 0x200F}, {0x202A, 0x202E},
                                     {0x2060, 0x206F}, {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF}};
  return isInBlocks(c, kBlocks);
}

bool isWide(char32_t c) {
  constexpr LetterBlock kBlocks[] = {{0x1100, 0x11FF}, {0x2E80, 0x303E}, {0x3041, 0x33FF}, {0x3400, 0x4DBF},
                                     {0x4E00, 0x9FFF}, {0xA960, 0xA97F}, {0xAC00, 0xD7FF}, {0xF900, 0xFAFF},
                                     {0xFE30, 0xFE4F}, {0xFF01, 0xFF60}, {0xFFE0, 0xFFE6}};
  return isInBlocks(c, kBlocks);
}

bool isKana(char32_t c) {
  constexpr LetterBlock kBlocks[] = {{0x3041, 0x30FF}, {0x31F0, 0x31FF}, {0xFF66, 0xFF9F}};
  return isInBlocks(c, kBlocks);
}

bool isHangul(char32_t c) {
  constexpr LetterBlock kBlocks[] = {{0x1100, 0x11FF}, {0x3130, 0x318F}, {0xA960, 0xA97F}, {0xAC00, 0xD7FF}};
  return isInBlocks(c, kBlocks);
}

bool isRightToLeft(char32_t c) {
  constexpr LetterBlock kBlocks[] = {{0x590, 0x8FF}, {0xFB1D, 0xFDFF}, {0xFE70, 0xFEFE}, {0x10800, 0x10FFF}};
  return isInBlocks(c, kBlocks);
}

bool isJoinedForm(char32_t c) {
  constexpr LetterBlock kBlocks[] = {{0xFB50, 0xFDFF}, {0xFE70, 0xFEFE}};
  return isInBlocks(c, kBlocks);
}

}  // namespace sinew::app
