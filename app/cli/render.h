// app/cli/render.h: `sinew render`: pictures of a character or rig, off screen.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sinew/base/geometry.h"

namespace CLI {
class App;
}

namespace sinew::app {

struct RenderOptions {
  std::filesystem::path input;
  std::filesystem::path output;  ///< .png; with frames a printf integer field such as %04d in its name.
  std::string clip;              ///< Name; empty: the first if a time or frames are given, else the bind pose.
  std::optional<double> time;    ///< Seconds.
  std::string frames;            ///< "A:B", both ends included.
  double framesPerSecond = 30.0;
  std::string view = "three-quarter";  ///< A named view, or "yaw,pitch" in degrees.
  bool orthographic = false;
  std::string shading = "textured";
  std::vector<std::string> show;
  bool cull = false;
  bool surface = true;  ///< Off: what is shown of muscles, bones and control mesh alone.
  bool ground = true;
  bool transparent = false;
  std::string size = "1280x800";
  int samples = 4;
  std::optional<int> depth;
  std::optional<float> crease;  ///< Degrees.
  std::string mode;
  std::string patch;
  std::string projection;
};

/// Adds the verb's options to its subcommand; `options` must outlive the parse.
void addRenderOptions(CLI::App& verb, RenderOptions& options);

/// Paths of the written pictures go to stdout, times and messages to stderr. 0 done, 1 bad input, 2 bad command line.
[[nodiscard]] int runRender(const RenderOptions& options);

}  // namespace sinew::app
