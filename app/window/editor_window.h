// app/window/editor_window.h: the editor in its window, from start to close.
#pragma once

#include <filesystem>
#include <string>

#include "app/editor/editor_state.h"
#include "app/ui/code_points.h"

namespace sinew::app {

/// Letters beyond ASCII in the names of file, bones, clips, shapes, muscles and groups.
[[nodiscard]] std::u32string lettersOfNames(const EditorState& state);
/// A message if no font has some of the letters; else "".
[[nodiscard]] std::string missingLetters(const std::u32string& letters, const HasGlyph& hasGlyph);

struct EditorOptions {
  std::filesystem::path file;      ///< Character or rig; empty: a bundled sample.
  std::filesystem::path logState;  ///< --log-state; empty: none.
  float scale = 0.0f;              ///< --scale; 0: from the preferences or the system.
};

/// @return exit status: 0, or 1 after a line on stderr (no display, no OpenGL 4.5, unreadable file or unwritable log)
[[nodiscard]] int runEditor(const EditorOptions& options);

}  // namespace sinew::app
