// app/window/name_letters.cpp: all names of a document, as letters.

#include "app/window/name_letters.h"

#include <algorithm>

#include "app/ui/code_points.h"

namespace sinew::app {
namespace {

template <class Named>
void addNameLetters(std::u32string& letters, const std::vector<Named>& all) {
  for (const Named& each : all) letters += codePoints(each.name);
}

}  // namespace

std::u32string lettersOfNames(const EditorState& state) {
  std::u32string letters = codePoints(state.document.name());
  if (state.hasCharacter()) {
    const Character& character = state.character();
    addNameLetters(letters, character.skeleton.bones);
    addNameLetters(letters, character.clips);
    addNameLetters(letters, character.morphTargets);
    addNameLetters(letters, character.parts);
    addNameLetters(letters, state.document.rig().primitives);
    addNameLetters(letters, state.document.rig().groups);
    for (const LayerChoice& choice : state.document.rig().layers) letters += codePoints(choice.part);
  }
  std::erase_if(letters, [](char32_t c) { return c < 0x80; });
  return letters;
}

std::string missingLetters(const std::u32string& letters, const HasGlyph& hasGlyph) {
  const auto missing = [&](char32_t c) { return !isInvisible(c) && !hasGlyph(c); };
  const auto wide = [&](char32_t c) { return isWide(c) && missing(c); };
  if (std::ranges::none_of(letters, missing)) return "";
  std::string text = "Some names are shown by number: no installed font has their letters.";
  if (std::ranges::any_of(letters, wide)) text += " Debian's package fonts-noto-cjk has Chinese, Japanese and Korean.";
  return text;
}

}  // namespace sinew::app
