// app/command/render_plan.h: a `sinew render` command line as numbers; its inputs, moments and view.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/command/batch.h"
#include "app/command/surface_options.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/render/view.h"
#include "app/viewport/render/viewport.h"
#include "core/rig/posed_rig.h"
#include "sinew/character/animation_clip.h"
#include "sinew/character/character.h"
#include "sinew/geometry/geometry.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// Pictures in rows, from left to right and top to bottom; cells without a picture are transparent.
/// @param cells  columns, rows  @param pictures  1 to as many as cells, all of one size
[[nodiscard]] Image contactSheet(const std::vector<Image>& pictures, const glm::ivec2& cells);

/// At most `most` of `count` indices, evenly spread, the first and last among them.
[[nodiscard]] std::vector<std::size_t> evenly(std::size_t count, std::size_t most);

inline constexpr int kMostTurns = 10000;

/// As given on the command line.
struct RenderOptions {
  std::filesystem::path input;
  std::filesystem::path output;    ///< .png, or isMovieName(); its fields as planBatch.
  std::vector<std::string> clips;  ///< Files whose clips are added.
  std::string clip;                ///< Empty: the first if a time or frames are given, else the bind pose.
  std::optional<double> time;      ///< Seconds.
  BatchOptions batch;
  int turntable = 0;                   ///< Pictures once around; 0: none.
  std::string sheet;                   ///< "CxR"; empty: none.
  std::string view = "three-quarter";  ///< A named view, or "yaw,pitch" in degrees.
  bool orthographic = false;
  std::string shading = "textured";
  std::vector<std::string> show;
  float glass = DisplaySettings{}.glass;
  std::string on = "processor";  ///< Where the surface is computed: "processor" or "gpu".
  bool surface = true;           ///< Off: only muscles, bones and control mesh.
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
  std::vector<int> frames;    ///< [moments] of the clip; empty: moments without frame numbers.
  std::vector<double> times;  ///< [moments] seconds into the clip.
  int turntable = 0;          ///< Pictures once around; 0: a fixed eye.
  glm::ivec2 sheet{0};        ///< Columns and rows of a contact sheet; 0: none.
  bool spreads = false;       ///< The sheet's moments are spread over the clip.
  bool isMovie = false;
  double picturesPerSecond = 30.0;  ///< For a movie.
  bool animated = false;            ///< Plays a clip; else the bind pose.
  float yaw = 0.0f;                 ///< Radians, as framing.h counts them.
  float pitch = 0.0f;
  glm::ivec2 size{1280, 800};
  int samples = 4;
  DisplaySettings display;
  bool onCard = false;   ///< Compute the surface on the graphics card if it can.
  bool anchors = false;  ///< Draw segments from the control vertices to the skeleton.

  /// A picture is the mean of many drawings: occlusion without noise, or muscles with more than 4 samples.
  [[nodiscard]] bool isMean() const { return display.look.occlusion || (display.anatomy && samples > 4); }
  /// All pictures of an input are in one file.
  [[nodiscard]] bool isOneFile() const { return isMovie || sheet.x > 0; }
};

[[nodiscard]] Result<RenderPlan> planRender(const RenderOptions& options);  ///< Error: place is the option.

/// A picture of the job.
struct Moment {
  double time = 0.0;  ///< Seconds into the clip.
  float turn = 0.0f;  ///< Radians of the eye around the character.
};

/// An input, ready to draw.
struct OpenedInput {
  std::shared_ptr<const Character> character;
  Rig rig;
  const AnimationClip* clip = nullptr;  ///< Null: the bind pose.
  std::vector<Moment> moments;          ///< All moments that the clip holds, in order.
  std::vector<std::size_t> wanted;      ///< Those to make now.
  std::string left;                     ///< As ClipFrames::left.
};

[[nodiscard]] Result<OpenedInput> openToRender(const RenderOptions& options, const RenderPlan& plan,
                                               const BatchInput& input);

/// One view for all moments, so that a clip's pictures do not shake. A moment turns it about the character.
struct SteadyView {
  View view;
  glm::vec3 center{0.0f};  ///< On the vertical axis.

  [[nodiscard]] View at(const Moment& moment) const;
};
[[nodiscard]] SteadyView steadyView(const OpenedInput& input, const RenderOptions& options, const RenderPlan& plan);

/// The rig with one detail for all pictures where it follows the size on screen; reports it.
[[nodiscard]] Rig settled(const OpenedInput& input, const View& view);

}  // namespace sinew::app
