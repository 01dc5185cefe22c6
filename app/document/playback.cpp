// app/document/playback.cpp: clip time -> pose -> surface.
#include "app/document/playback.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/stopwatch.h"
#include "core/surface/stages.h"
#include "sinew/character/character_pose.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

namespace {

constexpr float kDeadBand = 0.75f;  ///< Steps. At 0.5 or less there would be no hysteresis.

/// `time` in [0, duration), for negative times too.
double wrapped(double time, double duration) {
  const double rest = std::fmod(time, duration);
  return rest < 0.0 ? rest + duration : rest;
}

/// The interval that plays at the current time: the range, or the whole clip after its end.
PlayRange aroundTime(const Transport& transport, const Character& character) {
  const PlayRange range = playRange(transport, character);
  return transport.time > range.to ? PlayRange{0.0, clipDuration(transport, character)} : range;
}

bool samePose(const Transport& a, const Transport& b) {
  return a.clip == b.clip && a.time == b.time && a.overrides == b.overrides && a.flex == b.flex &&
         a.flexedLines == b.flexedLines;
}

}  // namespace

float meanEdgeFraction(const ControlMesh& mesh, float height) {
  if (mesh.edges.empty()) return 1.0f;
  double sum = 0.0;
  for (const Edge& edge : mesh.edges) {
    sum +=
        static_cast<double>(glm::distance(at(mesh.positions, edge.vertices[0]), at(mesh.positions, edge.vertices[1])));
  }
  return static_cast<float>(sum / static_cast<double>(mesh.edges.size())) / height;
}

int autoDepth(float meanEdgeFraction, float heightPixels, int current) {
  const float ideal =
      std::clamp(meanEdgeFraction * heightPixels / kAutoEdgePixels, 1.0f, static_cast<float>(kMaxAutoDepth));
  if (!std::isfinite(ideal)) return current > 0 ? current : 1;
  const bool settled =
      current >= 1 && current <= kMaxAutoDepth && std::abs(ideal - static_cast<float>(current)) <= kDeadBand;
  return settled ? current : static_cast<int>(std::lround(ideal));
}

float autoTolerance(float heightPixels, float current) {
  const float ideal = std::clamp(kAutoErrorPixels / heightPixels, kLeastTolerance, kMostTolerance);
  if (!std::isfinite(ideal)) return current > 0.0f ? current : kDefaultTolerance;
  const float step = 2.0f * std::log2(ideal);
  if (current > 0.0f && std::abs(step - 2.0f * std::log2(current)) <= kDeadBand) return current;
  return std::clamp(std::exp2(0.5f * std::round(step)), kLeastTolerance, kMostTolerance);
}

double clipDuration(const Transport& transport, const Character& character) {
  if (transport.clip < 0) return 0.0;
  return static_cast<double>(character.clips[static_cast<std::size_t>(transport.clip)].duration);
}

PlayRange playRange(const Transport& transport, const Character& character) {
  const double duration = clipDuration(transport, character);
  const auto found = transport.ranges.find(transport.clip);
  if (found == transport.ranges.end()) return {0.0, duration};
  const PlayRange range{std::clamp(found->second.from, 0.0, duration), std::clamp(found->second.to, 0.0, duration)};
  return range.to > range.from ? range : PlayRange{0.0, duration};
}

bool hasPlayRange(const Transport& transport) { return transport.ranges.contains(transport.clip); }

void setPlayRange(Transport& transport, const PlayRange& range, const Character& character) {
  const double duration = clipDuration(transport, character);
  const auto onFrame = [&](double time) {
    const double frame = std::round(time / kFrameSeconds) * kFrameSeconds;
    return std::clamp(duration - frame < 0.5 * kFrameSeconds ? duration : frame, 0.0, duration);
  };
  const double from = std::min(onFrame(range.from), std::max(0.0, duration - kFrameSeconds));
  const double to = std::min(std::max(onFrame(range.to), from + kFrameSeconds), duration);
  if (from <= 0.0 && to >= duration) transport.ranges.erase(transport.clip);
  else transport.ranges[transport.clip] = {from, to};
}

void advance(Transport& transport, double seconds, const Character& character) {
  const double duration = clipDuration(transport, character);
  if (!transport.playing || duration <= 0.0) return;
  const PlayRange range = aroundTime(transport, character);
  const double time = transport.time + seconds * static_cast<double>(transport.speed);
  if (time < range.to) {
    transport.time = std::max(time, 0.0);
  } else if (transport.loop) {
    const PlayRange again = playRange(transport, character);
    transport.time = again.from + wrapped(time - range.to, again.to - again.from);
  } else {
    transport.time = range.to;
    transport.playing = false;
  }
}

void stepFrames(Transport& transport, int frames, const Character& character) {
  const double duration = clipDuration(transport, character);
  transport.playing = false;
  if (duration <= 0.0) return;
  const double frame = std::round(transport.time / kFrameSeconds) + frames;
  const double time = frame * kFrameSeconds;
  PlayRange range = aroundTime(transport, character);
  if (transport.time < range.from) range.from = 0.0;
  constexpr double kRounding = 1e-9;
  if (time >= range.from - kRounding && time <= range.to + kRounding) {
    transport.time = std::clamp(time, 0.0, duration);
  } else if (transport.loop) {
    transport.time = range.from + wrapped(time - range.from, range.to - range.from);
  } else {
    transport.time = std::clamp(time, range.from, range.to);
  }
}

void chooseClip(Transport& transport, int clip, const Character& character) {
  transport.clip = clip;
  transport.time = playRange(transport, character).from;
  transport.playing = transport.playing && clipDuration(transport, character) > 0.0;
}

void togglePlaying(Transport& transport, const Character& character) {
  const double duration = clipDuration(transport, character);
  transport.playing = !transport.playing && duration > 0.0;
  const bool atEnd = transport.time >= aroundTime(transport, character).to;
  if (transport.playing && atEnd) transport.time = playRange(transport, character).from;
}

Pose poseAt(const Transport& transport, const Character& character) {
  const Skeleton& skeleton = character.skeleton;
  const auto sampled = [&] {
    if (transport.clip < 0) return bindPose(skeleton);
    const AnimationClip& clip = character.clips[static_cast<std::size_t>(transport.clip)];
    return samplePose(character, clip, static_cast<float>(transport.time));
  };
  Pose pose = posed(skeleton, sampled(), transport.overrides);
  pose.flex = transport.flex;
  pose.flexedLines = transport.flexedLines;
  return pose;
}

LiveSurface::LiveSurface(std::shared_ptr<const Character> character)
    : tables_(characterTables(std::move(character))),
      meanEdge_(meanEdgeFraction(tables_->character->mesh, tables_->character->height)) {}

Result<LiveSurface> LiveSurface::create(const Document& document, const Transport& transport) {
  LiveSurface live(document.character);
  live.movePose(transport);
  if (const auto updated = live.update(document); !updated) return updated.error();
  return live;
}

LiveSurface::Detail LiveSurface::detailFor(const SmoothingSettings& settings, float heightPixels) const {
  if (!settings.autoDepth) return {settings.depth, settings.tolerance};
  if (heightPixels > 0.0f) {
    return {autoDepth(meanEdge_, heightPixels, detail_.depth),
            autoTolerance(heightPixels, followed_ ? detail_.tolerance : 0.0f)};
  }
  return followed_ ? detail_ : Detail{settings.depth, settings.tolerance};
}

/// A drag keeps the mesh's refinement levels; they are recomputed when it ends.
Result<bool> LiveSurface::prepareIfChanged(const Document& document, const Detail& detail,
                                           const std::vector<int>& hidden) {
  const bool drags = document.commands.inGesture();
  const bool same = triedRig_ == document.commands.revision() && detail_ == detail && hidden_ == hidden;
  if (same && (drags || !keptLevels_)) return false;
  triedRig_ = document.commands.revision();
  detail_ = detail;
  hidden_ = hidden;
  keptLevels_ = drags;
  PreparationOptions options{hidden, {}, detail.tolerance, drags, document.commands.sharedRig(), document.poser()};
  if (document.rig().smoothing.detail == DetailKind::kUniform) options.depth = detail.depth;
  Stopwatch watch;
  auto prepared = prepare(tables_, document.rig(), options, preparation_.get(), graphs_);
  prepareSeconds_ = watch.lap();
  if (!prepared) return prepared.error();
  preparation_ = std::move(prepared).value();
  return true;
}

void LiveSurface::smooth(const PosedRig& rig, double posingSeconds) const {
  sinew::smooth(preparation_, rig, pose_, std::nullopt, made_.memory, made_.surface, posingSeconds);
  made_.waits = false;
}

const Surface& LiveSurface::surface() const {
  if (!made_.waits) return made_.surface;
  Stopwatch watch;
  preparation_->poser->pose(pose_, made_.rig);
  smooth(made_.rig, watch.lap());
  return made_.surface;
}

void LiveSurface::movePose(const Transport& transport) {
  if (posed_ && samePose(*posed_, transport)) return;
  pose_ = poseAt(transport, *tables_->character);
  posed_ = transport;
  moved_ = true;
}

Result<bool> LiveSurface::update(const Document& document, const SurfaceView& view) {
  const SmoothingSettings& settings = document.rig().smoothing;
  const Detail detail = detailFor(settings, view.heightPixels);
  followed_ = settings.autoDepth && (followed_ || view.heightPixels > 0.0f);
  const Result<bool> prepared = prepareIfChanged(document, detail, view.hidden);
  if (!prepared && revision_ == 0) return prepared;
  const bool stale = moved_ || (prepared.ok() && prepared.value());
  if (stale) {
    moved_ = false;
    ++revision_;
    made_.waits = true;
  }
  if (stale && view.onCard) {
    // Counted by smoothing in a pose; it hardly differs between poses.
    const int unwrapped = made_.surface.report.unwrapped;
    made_.surface.report = reportOf(*preparation_);
    made_.surface.report.unwrapped = unwrapped;
  } else if (made_.waits && !view.onCard) {
    Stopwatch watch;
    // While a rig is refused, the surface still shows the last accepted rig, which the document does not pose.
    if (preparation_->poser == document.poser()) {
      const PosedRig& rig = document.posedRig(pose_);
      smooth(rig, watch.lap());
    } else {
      (void)surface();
    }
  }
  return prepared ? Result<bool>(stale) : prepared;
}

}  // namespace sinew::app
