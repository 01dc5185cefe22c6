// app/command/render_plan.cpp: words of the command line become numbers.
#include "app/command/render_plan.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "app/viewport/render/picture_files.h"
#include "app/viewport/render/scene.h"
#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

constexpr int kSmallestPicture = 16;
constexpr int kLargestPicture = 8192;
constexpr long long kLargestSheet = 16384;

struct NamedView {
  std::string_view name;
  float yaw, pitch;  ///< Degrees.
};
constexpr std::array<NamedView, 7> kViews{{{"front", 0, 0},
                                           {"back", 180, 0},
                                           {"left", 90, 0},
                                           {"right", -90, 0},
                                           {"top", 0, 90},
                                           {"bottom", 0, -90},
                                           {"three-quarter", 36, 14}}};

/// The whole text as a number, or nullopt.
template <class Number>
std::optional<Number> numberIn(std::string_view text) {
  Number value{};
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

template <class Number>
std::optional<std::array<Number, 2>> pairIn(std::string_view text, char between) {
  const std::size_t at = text.find(between);
  if (at == std::string_view::npos) return std::nullopt;
  const auto first = numberIn<Number>(text.substr(0, at)), second = numberIn<Number>(text.substr(at + 1));
  if (!first || !second) return std::nullopt;
  return std::array<Number, 2>{*first, *second};
}

Result<void> readView(const std::string& text, RenderPlan& plan) {
  constexpr float kRadians = std::numbers::pi_v<float> / 180.0f;
  const auto named = std::ranges::find(kViews, std::string_view(text), &NamedView::name);
  float yaw = 0.0f, pitch = 0.0f;
  if (named != kViews.end()) {
    yaw = named->yaw;
    pitch = named->pitch;
  } else {
    const auto angles = pairIn<float>(text, ',');
    if (!angles || !std::isfinite((*angles)[0]) || !(std::abs((*angles)[1]) <= 90.0f)) {
      return errorAt("--view",
                     "expected front, back, left, right, top, bottom, three-quarter, or yaw,pitch in degrees "
                     "(pitch -90 to 90), got \"" +
                         text + '"');
    }
    yaw = std::fmod((*angles)[0], 360.0f);
    pitch = (*angles)[1];
  }
  plan.yaw = yaw * kRadians;
  plan.pitch = pitch * kRadians;
  return {};
}

Result<void> readSize(const std::string& text, RenderPlan& plan) {
  const auto size = pairIn<int>(text, 'x');
  const auto fits = [](int length) { return length >= kSmallestPicture && length <= kLargestPicture; };
  if (!size || !fits((*size)[0]) || !fits((*size)[1])) {
    return errorAt("--size", "expected WIDTHxHEIGHT, each 16 to 8192, got \"" + text + '"');
  }
  plan.size = {(*size)[0], (*size)[1]};
  return {};
}

Result<void> readDisplay(const RenderOptions& options, RenderPlan& plan) {
  plan.samples = options.samples;
  DisplaySettings& display = plan.display;
  const auto shading = lookNamed<Shading>(kShadingNames, options.shading);
  if (!shading) {
    return errorAt("--shading", "expected textured, clay, classes or heat, got \"" + options.shading + '"');
  }
  display.shading = *shading;
  for (const std::string& shown : options.show) {
    if (shown == "skeleton") display.skeleton = true;
    else if (shown == "primitives") display.primitives = true;
    else if (shown == "muscles") display.anatomy = true;
    else if (shown == "influence") display.influence = true;
    else if (shown == "wire") display.wire = true;
    else if (shown == "relief") display.relief = true;
    else if (shown == "control") display.controlMesh = true;
    else if (shown == "anchors") plan.anchors = true;
    else if (shown == "classes") display.shading = Shading::kClasses;
    else {
      return errorAt("--show",
                     "expected muscles, skeleton, primitives, influence, wire, relief, control, anchors or classes, "
                     "got \"" +
                         shown + '"');
    }
  }
  const auto light = lightNamed(options.light);
  if (!light) return errorAt("--light", "expected studio, outdoor, rim or white, got \"" + options.light + '"');
  const auto backdrop = backdropNamed(options.background);
  if (!backdrop) {
    return errorAt("--background",
                   "expected studio, dark, mid, light, gradient or checker, got \"" + options.background + '"');
  }
  display.look = {*light, *backdrop, options.occlusion};
  if (!(options.glass >= 0.0f && options.glass <= 1.0f)) return errorAt("--glass", "expected a number from 0 to 1");
  display.glass = options.glass;
  display.cullBackFaces = options.cull;
  display.surface = options.surface;
  display.ground = options.ground;
  display.background = !options.transparent;
  return {};
}

/// Where the surface is computed.
Result<void> readPlace(const RenderOptions& options, RenderPlan& plan) {
  plan.onCard = options.on == "gpu";
  if (!plan.onCard) return {};
  if (options.cull) return errorAt("--on", "gpu cannot be combined with --cull: only the processor leaves faces out");
  if (plan.anchors) return errorAt("--on", "gpu cannot be combined with --show anchors: they need the surface itself");
  return {};
}

Result<void> readSheet(const std::string& text, RenderPlan& plan) {
  if (text.empty()) return {};
  const auto cells = pairIn<int>(text, 'x');
  const auto fits = [&](int axis) {
    const int count = (*cells)[static_cast<std::size_t>(axis)];
    return count >= 1 && static_cast<long long>(count) * plan.size[axis] <= kLargestSheet;
  };
  if (!cells || !fits(0) || !fits(1)) {
    return errorAt("--sheet",
                   "expected COLUMNSxROWS of pictures as large as --size, at most 16384 pixels wide and high, "
                   "got \"" +
                       text + '"');
  }
  plan.sheet = {(*cells)[0], (*cells)[1]};
  return {};
}

/// What the ending of the output, --sheet, --turntable and --frames make together.
Result<void> readForm(const RenderOptions& options, RenderPlan& plan) {
  plan.isMovie = isMovieName(options.output);
  if (!plan.isMovie && lowerEnding(options.output) != ".png") {
    return errorAt("--output",
                   "expected a name that ends in .png, .webp, .gif or .mp4, got \"" + options.output.string() + '"');
  }
  const bool hasFrames = !options.batch.frames.empty();
  if (options.time && hasFrames) {
    return errorAt("--time", "cannot be combined with --frames: a frame's number is its time");
  }
  if (plan.isMovie && plan.sheet.x > 0)
    return errorAt("--sheet", "expected a name that ends in .png: it is one picture");
  if (plan.isMovie && !hasFrames && options.turntable == 0) {
    return errorAt("--output", "a moving picture needs --frames or --turntable");
  }
  plan.turntable = options.turntable;
  plan.animated = !options.clip.empty() || options.time || hasFrames;
  const bool isBare = plan.sheet.x > 0 && !hasFrames && options.turntable == 0;
  plan.spreads = isBare && !options.clip.empty() && !options.time;
  if (isBare && !plan.spreads) plan.turntable = plan.sheet.x * plan.sheet.y;
  return plan.isMovie ? checkMovieName(options.output) : Result<void>();
}

Result<void> readMoments(const RenderOptions& options, RenderPlan& plan) {
  const auto frames = frameNumbers(options.batch);
  if (!frames) return frames.error();
  plan.frames = frames.value();
  BatchOptions naming = options.batch;
  if (plan.isOneFile()) naming.frames.clear();
  else if (plan.turntable > 0 && plan.frames.empty()) naming.frames = "0:" + std::to_string(plan.turntable - 1);
  auto batch = planBatch(naming, options.input, options.output);
  if (!batch) return batch.error();
  plan.batch = std::move(batch.value());
  plan.picturesPerSecond = options.batch.framesPerSecond;
  if (plan.frames.size() > 1) plan.picturesPerSecond /= plan.frames[1] - plan.frames[0];
  for (const int frame : plan.frames) plan.times.push_back(frame / options.batch.framesPerSecond);
  if (!plan.frames.empty()) return {};
  const double time = options.time.value_or(0.0);
  if (!(time >= 0.0) || !std::isfinite(time)) return errorAt("--time", "expected seconds >= 0");
  plan.times.assign(static_cast<std::size_t>(std::max(plan.turntable, 1)), time);
  return {};
}

}  // namespace

Result<RenderPlan> planRender(const RenderOptions& options) {
  RenderPlan plan;
  if (const auto read = readView(options.view, plan); !read) return read.error();
  if (const auto read = readSize(options.size, plan); !read) return read.error();
  if (const auto read = readDisplay(options, plan); !read) return read.error();
  if (const auto read = readPlace(options, plan); !read) return read.error();
  if (const auto read = readSheet(options.sheet, plan); !read) return read.error();
  if (const auto read = readForm(options, plan); !read) return read.error();
  if (const auto read = readMoments(options, plan); !read) return read.error();
  return plan;
}

}  // namespace sinew::app
