// app/cli/inspect.h: `sinew inspect`: what a character or rig holds.
#pragma once

#include <filesystem>

namespace CLI {
class App;
}

namespace sinew::app {

struct InspectOptions {
  std::filesystem::path file;
  bool json = false;
};

/// Adds the verb's options to its subcommand; `options` must outlive the parse.
void addInspectOptions(CLI::App& verb, InspectOptions& options);

/// Exit status as console.h names them.
[[nodiscard]] int runInspect(const InspectOptions& options);

}  // namespace sinew::app
