// app/command/verbs.h: parses and runs a command line.
#pragma once

#include <functional>
#include <string>

namespace sinew::app {

/// Options of the editor; main passes them on, since the command line must not depend on the window.
struct EditRequest {
  std::string file;      ///< "" for the bundled character.
  std::string logState;  ///< "" for none.
  float scale = 0.0f;    ///< 0: from preferences or the system.
};
using RunEditor = std::function<int(const EditRequest&)>;

/// Runs the verb of a command line, or `edit` without one. Returns the exit status (docs/formats.md).
[[nodiscard]] int runCommandLine(int argc, const char* const* argv, const RunEditor& edit);

}  // namespace sinew::app
