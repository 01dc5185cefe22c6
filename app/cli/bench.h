// app/cli/bench.h: `sinew bench`: measurements on this machine.
#pragma once

#include <filesystem>
#include <vector>

namespace CLI {
class App;
}

namespace sinew::app {

/// `sinew bench projections`: the three ways to find roots, on the same frames.
/// `sinew bench field`: the field of spheres beside that of ellipsoids.
struct BenchOptions {
  bool field = false;                        ///< Else projections.
  std::vector<std::filesystem::path> files;  ///< Rigs or characters; none: those that ship with the program.
  std::filesystem::path json;                ///< Empty: none.
  int frames = 8;                            ///< Moments of the first clip.
  int rounds = 15;                           ///< Each frame is timed once a round.
};

/// Adds the verb's parts and options to its subcommand; `options` must outlive the parse.
void addBenchOptions(CLI::App& verb, BenchOptions& options);

/// The table goes to stdout, progress to stderr. Exit status as console.h names them.
[[nodiscard]] int runBench(const BenchOptions& options);

}  // namespace sinew::app
