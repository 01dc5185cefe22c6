// app/command/verbs.h: the command line as a whole: which verb, with which options.
#pragma once

#include <functional>
#include <string>

namespace sinew::app {

/// What the editor is started with; main hands it on, as the command line must not know the window.
struct EditRequest {
  std::string file;      ///< "" for the bundled character.
  std::string logState;  ///< "" for none.
  float scale = 0.0f;    ///< 0: what preferences or system say.
};
using RunEditor = std::function<int(const EditRequest&)>;

/// Reads the command line and runs its verb; `edit` is what runs without one. Returns the exit status
/// (docs/formats.md).
[[nodiscard]] int runCommandLine(int argc, const char* const* argv, const RunEditor& edit);

}  // namespace sinew::app
