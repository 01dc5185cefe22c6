// app/command/render_plan.h: what a `sinew render` command line asks for, read and checked.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/command/batch.h"
#include "app/command/surface_options.h"
#include "app/viewport/render/scene.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

inline constexpr int kMostTurns = 10000;

/// As the command line says it.
struct RenderOptions {
  std::filesystem::path input;
  std::filesystem::path output;    ///< .png, or isMovieName(); its fields as planBatch.
  std::vector<std::string> clips;  ///< Files whose clips are added.
  std::string clip;                ///< Name; empty: the first if a time or frames are given, else the bind pose.
  std::optional<double> time;      ///< Seconds.
  BatchOptions batch;
  int turntable = 0;                   ///< Pictures once around; 0: none.
  std::string sheet;                   ///< "CxR"; empty: none.
  std::string view = "three-quarter";  ///< A named view, or "yaw,pitch" in degrees.
  bool orthographic = false;
  std::string shading = "textured";
  std::vector<std::string> show;
  float glass = DisplaySettings{}.glass;
  bool cull = false;
  std::string on = "processor";  ///< Where the surface is computed: "processor" or "gpu".
  bool surface = true;           ///< Off: what is shown of muscles, bones and control mesh alone.
  bool ground = true;
  bool transparent = false;
  std::string light = "studio";
  std::string background = "studio";
  bool occlusion = false;
  std::string size = "1280x800";
  int samples = 4;
  SurfaceOptions surfaceOptions;
};

struct RenderPlan {
  Batch batch;
  std::vector<int> frames;    ///< [moments] of the clip; empty: the moments are no frames.
  std::vector<double> times;  ///< [moments] seconds into the clip, of every input.
  int turntable = 0;          ///< Pictures once around; 0: the eye stays.
  glm::ivec2 sheet{0};        ///< Columns and rows of a contact sheet; 0: none.
  bool spreads = false;       ///< The sheet's moments are spread over the clip.
  bool isMovie = false;
  double picturesPerSecond = 30.0;  ///< Of a movie.
  bool animated = false;            ///< A clip is wanted; else the bind pose.
  float yaw = 0.0f;                 ///< Radians, as framing.h counts them.
  float pitch = 0.0f;
  glm::ivec2 size{1280, 800};
  int samples = 4;
  DisplaySettings display;
  bool onCard = false;   ///< The surface is computed on the graphics card, where that can.
  bool anchors = false;  ///< The segments from the control vertices to the skeleton.

  /// Ambient occlusion without noise is the mean of many drawings, which smooth the edges as well. Of muscles one
  /// drawing does unless more is asked for.
  [[nodiscard]] bool isMean() const { return display.look.occlusion || (display.anatomy && samples > 4); }
  /// All pictures of an input are in one file.
  [[nodiscard]] bool isOneFile() const { return isMovie || sheet.x > 0; }
};

/// Error: place is the option, reason what was expected of it.
[[nodiscard]] Result<RenderPlan> planRender(const RenderOptions& options);

}  // namespace sinew::app
