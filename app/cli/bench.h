// app/cli/bench.h: `sinew bench`: measurements on this machine.
#pragma once

#include <filesystem>
#include <vector>

namespace CLI {
class App;
}

namespace sinew::app {

enum class Bench {
  kProjections,  ///< The three ways to find roots, on the same frames.
  kField,        ///< The field of spheres beside that of ellipsoids.
  kDrag,         ///< Frames of a drag, by length of the history and number of muscles.
};

struct BenchOptions {
  Bench bench = Bench::kProjections;
  std::vector<std::filesystem::path> files;  ///< Rigs or characters; none: those that ship with the program.
  std::filesystem::path json;                ///< Empty: none.
  int frames = 0;                            ///< Moments of the clip or of the drag; 0: as many as the bench takes.
  int rounds = 0;                            ///< Each frame is timed once a round; 0: as many as the bench takes.
};

/// Adds the verb's parts and options to its subcommand; `options` must outlive the parse.
void addBenchOptions(CLI::App& verb, BenchOptions& options);

/// The table goes to stdout, progress to stderr. Exit status as console.h names them.
[[nodiscard]] int runBench(const BenchOptions& options);

}  // namespace sinew::app
