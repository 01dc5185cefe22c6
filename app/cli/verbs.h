// app/cli/verbs.h: the command line as a whole: which verb, with which options.
#pragma once

#include <functional>
#include <string>

#include "app/cli/bench.h"
#include "app/cli/inspect.h"
#include "app/cli/render.h"
#include "app/cli/smooth.h"

namespace sinew::app {

/// What the editor is started with; main hands it on, as the command line must not know the window.
struct EditRequest {
  std::string file;      ///< "" for the bundled character.
  std::string logState;  ///< "" for none.
  float scale = 0.0f;    ///< 0: what preferences or system say.
};

/// Reads the command line and runs its verb; `edit` is what runs without one. Returns the exit status
/// (docs/formats.md).
[[nodiscard]] int runCommandLine(int argc, const char* const* argv, const std::function<int(const EditRequest&)>& edit);

}  // namespace sinew::app
