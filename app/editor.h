#pragma once  // app/editor.h: the editor: one window from start to close.

#include <filesystem>

namespace sinew::app {

struct EditorOptions {
  std::filesystem::path file;      ///< Character or rig; empty: the bundled sample.
  std::filesystem::path logState;  ///< --log-state; empty: none.
};

/// Opens the window, runs it, closes it. @return exit status: 0, or 1 after a line on stderr (no display, no
/// OpenGL 4.5, the log cannot be written). A file that cannot be opened is told in the window, which then stays empty.
[[nodiscard]] int runEditor(const EditorOptions& options);

}  // namespace sinew::app
