// app/ui/readable_names.cpp: names by number where their letters are missing.

#include "app/ui/readable_names.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/ui/code_points.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

/// Written once, as the window opens, by the thread that draws.
HasGlyph& glyphsOfInterface() {
  static HasGlyph glyphs;
  return glyphs;
}

bool isPlain(const std::string& name) {
  return std::ranges::all_of(name, [](char c) { return static_cast<unsigned char>(c) < 0x80u; });
}

}  // namespace

std::string readable(const std::string& name, const std::string& instead, const HasGlyph& hasGlyph) {
  if (!hasGlyph || isPlain(name)) return name;
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
  if (!glyphsOfInterface() || isPlain(name)) return name;
  return readable(name, std::string(word) + ' ' + std::to_string(number), glyphsOfInterface());
}

std::string shownMuscleName(const Rig& rig, int primitive) {
  return readableName(at(rig.primitives, primitive).name, "muscle", primitive + 1);
}

std::string shownGroupName(const Rig& rig, int group) {
  return readableName(at(rig.groups, group).name, "group", group + 1);
}

std::string shownMorphName(const Rig& rig, int morph) {
  return readableName(at(rig.morphs, morph).name, "shape", morph + 1);
}

}  // namespace sinew::app
