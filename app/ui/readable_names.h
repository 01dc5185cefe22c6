// app/ui/readable_names.h: what stands for a name, or for the part of it, that no installed font can show.
#pragma once

#include <functional>
#include <string>

#include "sinew/rig/rig.h"

namespace sinew::app {

/// Whether there is a glyph for a code point.
using HasGlyph = std::function<bool(char32_t)>;

/// The name if all of it can be shown. Else `instead`, a word and the name's index such as "bone 12", in place of the
/// first letters that cannot, and nothing for the others: without a Japanese font the left arm's bone is "bone 12.L".
[[nodiscard]] std::string readable(const std::string& name, const std::string& instead, const HasGlyph& hasGlyph);

/// What the interface's fonts have. Where nobody has said so, as on the command line, all that there is.
void setGlyphs(HasGlyph hasGlyph);
/// readable() with these glyphs, `instead` being the word and the number.
[[nodiscard]] std::string readableName(const std::string& name, const char* word, int number);

/// Muscles, groups and morph targets as lists show them; counted from 1.
[[nodiscard]] std::string shownMuscleName(const Rig& rig, int primitive);
[[nodiscard]] std::string shownGroupName(const Rig& rig, int group);
[[nodiscard]] std::string shownMorphName(const Rig& rig, int morph);

}  // namespace sinew::app
