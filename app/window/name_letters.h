// app/window/name_letters.h: the letters that a document's names are written in.
#pragma once

#include <string>

#include "app/editor/editor_state.h"
#include "app/ui/readable_names.h"

namespace sinew::app {

/// Those of file, bones, clips, shapes, muscles and groups that no keyboard of ASCII has, in their order.
[[nodiscard]] std::u32string lettersOfNames(const EditorState& state);

/// A message where names are shown by number, and what would help; else "".
[[nodiscard]] std::string missingLetters(const std::u32string& letters, const HasGlyph& hasGlyph);

}  // namespace sinew::app
