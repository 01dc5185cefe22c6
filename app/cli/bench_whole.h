// app/cli/bench_whole.h: `sinew bench` without a subcommand.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace sinew::app {

struct WholeOptions {
  std::vector<std::filesystem::path> files;   ///< Rigs or characters; none: those that ship with the program.
  std::optional<std::filesystem::path> json;  ///< Empty path: on stdout in place of the table. nullopt: none.
  int rounds = 0;                             ///< 0: as many as it takes.
};

/// Opens, measures, and puts table or JSON. Returns the exit status.
[[nodiscard]] int benchWhole(WholeOptions options);

}  // namespace sinew::app
