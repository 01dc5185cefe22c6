// app/cli/smooth.h: `sinew smooth`: one smoothed surface as a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace sinew::app {

/// What is not given stays as the rig says.
struct SmoothOptions {
  std::filesystem::path file;       ///< Rig or character.
  std::filesystem::path output;     ///< .obj, .ply or .glb.
  std::filesystem::path report;     ///< JSON; empty: none.
  std::optional<std::string> clip;  ///< Absent: the bind pose.
  double time = 0.0;                ///< Seconds into the clip.
  std::optional<int> depth;
  std::optional<float> crease;  ///< Degrees.
  std::optional<std::string> mode;
  std::optional<std::string> patch;
  std::optional<std::string> projection;
};

/// Adds the verb's options to its subcommand; `options` must outlive the parse.
void addSmoothOptions(CLI::App& verb, SmoothOptions& options);

/// Exit status as console.h names them.
[[nodiscard]] int runSmooth(const SmoothOptions& options);

}  // namespace sinew::app
