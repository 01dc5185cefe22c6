// app/command/render_plan.cpp: parses the options, opens inputs, frames all moments.

#include "app/command/render_plan.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>
#include <string_view>

#include <glm/gtc/matrix_transform.hpp>

#include "app/command/console.h"
#include "app/document/document.h"
#include "app/document/playback.h"
#include "app/viewport/render/picking.h"
#include "app/viewport/render/picture_files.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/render/view.h"
#include "core/character/bone_segments.h"
#include "core/character/skinning.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/motion_clip.h"

namespace sinew::app {

Image contactSheet(const std::vector<Image>& pictures, const glm::ivec2& cells) {
  assert(!pictures.empty() && pictures.size() <= static_cast<std::size_t>(cells.x * cells.y));
  const int width = pictures.front().width;
  const int height = pictures.front().height;
  Image sheet{width * cells.x, height * cells.y, {}};
  const auto rowBytes = 4 * static_cast<std::ptrdiff_t>(width);
  const std::ptrdiff_t sheetRow = rowBytes * cells.x;
  sheet.rgba.assign(static_cast<std::size_t>(sheetRow) * static_cast<std::size_t>(sheet.height), 0);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int column = static_cast<int>(i) % cells.x;
    const int row = static_cast<int>(i) / cells.x;
    for (int y = 0; y < height; ++y) {
      std::copy_n(pictures[i].rgba.begin() + y * rowBytes, rowBytes,
                  sheet.rgba.begin() + (row * height + y) * sheetRow + column * rowBytes);
    }
  }
  return sheet;
}

std::vector<std::size_t> evenly(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t shown = std::min(count, most);
  for (std::size_t i = 0; i < shown; ++i)
    chosen.push_back(shown == 1 ? 0 : (i * (count - 1) + (shown - 1) / 2) / (shown - 1));
  return chosen;
}

namespace {

constexpr int kSmallestPicture = 16;
constexpr int kLargestPicture = 8192;
constexpr long long kLargestSheet = 16384;

struct NamedView {
  std::string_view name;
  float yaw, pitch;  ///< Degrees.
};
constexpr std::array<NamedView, 7> kNamedViews{{{"front", 0, 0},
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
  const auto named = std::ranges::find(kNamedViews, std::string_view(text), &NamedView::name);
  float yaw = 0.0f, pitch = 0.0f;
  if (named != kNamedViews.end()) {
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
  display.surface = options.surface;
  display.ground = options.ground;
  display.background = !options.transparent;
  return {};
}

Result<void> readPlace(const RenderOptions& options, RenderPlan& plan) {
  plan.onCard = options.on == "gpu";
  if (!plan.onCard) return {};
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

/// Combines the ending of the output, --sheet, --turntable and --frames.
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

// Inputs, moments and views.

namespace {

constexpr int kFramedTurns = 24;  ///< Sides that a turntable is framed from.

/// Points that enclose what one moment shows: skin, ellipsoids, and bones if they are drawn.
void addFramedPoints(const OpenedInput& input, const PosedRig& posed, const Pose& pose, const DisplaySettings& display,
                     std::vector<glm::vec3>& points) {
  SkinnedMesh skinned;
  skin(*input.character, pose, posed.morphWeights, skinned);
  const std::vector<glm::vec3> extremes = extremePoints(skinned.positions);
  points.insert(points.end(), extremes.begin(), extremes.end());
  for (const PrimitiveShape& shape : shapesOf(input.rig, posed)) {
    if (shape.sign < 0 && !display.primitives && !display.influence && !display.anatomy) continue;
    const std::array<glm::vec3, 6> ends = extremesOf(shape, display.influence ? shape.reach : 1.0f);
    points.insert(points.end(), ends.begin(), ends.end());
  }
  if (!display.skeleton) return;
  for (const BoneSegment& segment : boneSegments(input.character->skeleton, pose)) {
    points.push_back(segment.head);
    points.push_back(segment.tail);
  }
}

/// Without frames: one moment, one per picture of a turntable, or one per cell of a sheet.
std::vector<Moment> momentsOf(const RenderPlan& plan, const AnimationClip* clip) {
  std::vector<Moment> moments;
  for (const double time : plan.times) moments.push_back({time, 0.0f});
  if (plan.spreads && clip != nullptr) {
    const int cells = plan.sheet.x * plan.sheet.y;
    moments.clear();
    for (int i = 0; i < cells; ++i) {
      moments.push_back({static_cast<double>(clip->duration) * i / std::max(cells - 1, 1), 0.0f});
    }
  }
  for (std::size_t i = 0; plan.turntable > 0 && i < moments.size(); ++i) {
    const double turns = static_cast<double>(i) / plan.turntable;
    moments[i].turn = static_cast<float>(2.0 * std::numbers::pi * (turns - std::floor(turns)));
  }
  return moments;
}

}  // namespace

Result<OpenedInput> openToRender(const RenderOptions& options, const RenderPlan& plan, const BatchInput& input) {
  auto document = openWithClips(input.file, options.clips);
  if (!document) return document.error();
  document.value().character = withClipNamed(document->character, options.clip);
  auto rig = overridden(document.value(), options.surfaceOptions);
  if (!rig) return rig.error();
  OpenedInput opened{document->character, std::move(rig).value(), nullptr, {}, {}, {}};
  if (auto attached = checkBones(opened.rig, opened.character->skeleton, input.file); !attached) {
    return attached.error();
  }
  if (plan.animated) {
    const auto named = options.clip.empty() ? std::nullopt : std::optional(options.clip);
    const auto clip = clipOf(document.value(), named, options.time.value_or(0.0));
    if (!clip) return clip.error();
    opened.clip = clip.value();
  }
  const auto frames = framesInClip(plan.frames, options.batch, input.wanted, opened.clip, document->characterFile);
  if (!frames) return frames.error();
  opened.moments = momentsOf(plan, opened.clip);
  if (!plan.frames.empty()) opened.moments.resize(frames->count);
  opened.wanted = plan.isOneFile() ? input.wanted : frames->wanted;
  opened.left = frames->left;
  if (plan.sheet.x > 0) {
    std::vector<Moment> shown;
    const auto room = static_cast<std::size_t>(plan.sheet.x * plan.sheet.y);
    for (const std::size_t i : evenly(opened.moments.size(), room)) shown.push_back(opened.moments[i]);
    opened.moments = std::move(shown);
  }
  return opened;
}

View SteadyView::at(const Moment& moment) const {
  if (moment.turn == 0.0f) return view;
  const glm::vec3 up(0.0f, 1.0f, 0.0f);
  const auto turned = [&](float angle) {
    const glm::mat4 there = glm::translate(glm::mat4(1.0f), center);
    return there * glm::rotate(glm::mat4(1.0f), angle, up) * glm::translate(glm::mat4(1.0f), -center);
  };
  View result = view;
  result.viewFromWorld = view.viewFromWorld * turned(-moment.turn);
  result.eyeInWorld = glm::vec3(turned(moment.turn) * glm::vec4(view.eyeInWorld, 1.0f));
  return result;
}

SteadyView steadyView(const OpenedInput& input, const RenderOptions& options, const RenderPlan& plan) {
  const RigPoser poser(input.rig, *input.character);
  std::vector<glm::vec3> points;
  std::optional<double> last;
  for (const Moment& moment : input.moments) {
    if (last == moment.time) continue;
    last = moment.time;
    const Pose pose = poseAt(*input.character, input.clip, moment.time);
    addFramedPoints(input, poser.pose(pose), pose, plan.display, points);
  }
  SteadyView steady;
  steady.center = boundsOf(points).center();
  if (plan.turntable > 0) {
    std::vector<glm::vec3> around;
    for (int i = 0; i < kFramedTurns; ++i) {
      const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kFramedTurns;
      const glm::mat3 turn(glm::rotate(glm::mat4(1.0f), angle, glm::vec3(0.0f, 1.0f, 0.0f)));
      for (const glm::vec3& point : points) around.push_back(steady.center + turn * (point - steady.center));
    }
    points = std::move(around);
  }
  steady.view = framedView(points, plan.yaw, plan.pitch, plan.size, options.orthographic);
  return steady;
}

Rig settled(const OpenedInput& input, const View& view) {
  Rig rig = input.rig;
  if (!rig.smoothing.autoDepth) return rig;
  const Character& character = *input.character;
  SkinnedMesh skinned;
  const Pose pose = poseAt(character, input.clip, input.moments.front().time);
  skin(character, pose, RigPoser(rig, character).pose(pose).morphWeights, skinned);
  const float pixels = character.height / view.unitsPerPixelAt(boundsOf(skinned.positions).center());
  if (rig.smoothing.detail == DetailKind::kAdaptive) {
    rig.smoothing.tolerance = autoTolerance(pixels, 0.0f);
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), "%.2g", static_cast<double>(rig.smoothing.tolerance));
    message("tolerance " + std::string(number.data()) + " for the character's size in the picture");
    return rig;
  }
  rig.smoothing.depth = autoDepth(meanEdgeFraction(character.mesh, character.height), pixels, 0);
  message("depth " + std::to_string(rig.smoothing.depth) + " for the character's size in the picture");
  return rig;
}

}  // namespace sinew::app
