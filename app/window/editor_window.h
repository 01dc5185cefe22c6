// app/window/editor_window.h: the editor: one window from start to close.
#pragma once

#include <filesystem>
#include <string>

#include "app/editor/editor_state.h"
#include "app/ui/code_points.h"

namespace sinew::app {

// The letters that a document's names are written in.

/// Those of file, bones, clips, shapes, muscles and groups that no keyboard of ASCII has, in their order.
[[nodiscard]] std::u32string lettersOfNames(const EditorState& state);

/// A message where names are shown by number, and what would help; else "".
[[nodiscard]] std::string missingLetters(const std::u32string& letters, const HasGlyph& hasGlyph);

struct EditorOptions {
  std::filesystem::path file;      ///< Character or rig; empty: a bundled sample.
  std::filesystem::path logState;  ///< --log-state; empty: none.
  float scale = 0.0f;              ///< --scale; 0: what the preferences or the system say.
};

/// Opens the window, runs it, closes it. @return exit status: 0, or 1 after a line on stderr (no display, no
/// OpenGL 4.5, the log cannot be written). A file that cannot be opened is reported in the window, which then stays
/// empty.
[[nodiscard]] int runEditor(const EditorOptions& options);

}  // namespace sinew::app
