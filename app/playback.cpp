// app/playback.cpp: clip time -> pose -> surface.

#include "app/playback.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/smoothing/auto_depth.h"

namespace sinew::app {
namespace {

/// time in [0, duration): fmod that is right for negative times too.
double wrapped(double time, double duration) {
  const double rest = std::fmod(time, duration);
  return rest < 0.0 ? rest + duration : rest;
}

}  // namespace

double clipDuration(const Transport& transport, const Character& character) {
  if (transport.clip < 0) return 0.0;
  return static_cast<double>(character.clips[static_cast<std::size_t>(transport.clip)].duration);
}

void advance(Transport& transport, double seconds, const Character& character) {
  const double duration = clipDuration(transport, character);
  if (!transport.playing || duration <= 0.0) return;
  const double time = transport.time + seconds * static_cast<double>(transport.speed);
  if (transport.loop) {
    transport.time = wrapped(time, duration);
  } else {
    transport.time = std::clamp(time, 0.0, duration);
    if (transport.time >= duration) transport.playing = false;
  }
}

void stepFrames(Transport& transport, int frames, const Character& character) {
  const double duration = clipDuration(transport, character);
  transport.playing = false;
  if (duration <= 0.0) return;
  const double frame = std::round(transport.time / kFrameSeconds) + frames;
  const double time = frame * kFrameSeconds;
  if (time >= 0.0 && time <= duration) {
    transport.time = time;
  } else {
    transport.time = transport.loop ? wrapped(time, duration) : std::clamp(time, 0.0, duration);
  }
}

void chooseClip(Transport& transport, int clip, const Character& character) {
  transport.clip = clip;
  transport.time = 0.0;
  transport.playing = transport.playing && clipDuration(transport, character) > 0.0;
}

void togglePlaying(Transport& transport, const Character& character) {
  const double duration = clipDuration(transport, character);
  transport.playing = !transport.playing && duration > 0.0;
  if (transport.playing && transport.time >= duration) transport.time = 0.0;
}

Pose poseAt(const Transport& transport, const Character& character) {
  if (transport.clip < 0) return bindPose(character.skeleton);
  return samplePose(character.skeleton, character.clips[static_cast<std::size_t>(transport.clip)],
                    static_cast<float>(transport.time));
}

LiveSurface::LiveSurface(std::shared_ptr<const Character> character)
    : character_(std::move(character)), smoother_(character_),
      meanEdge_(meanEdgeFraction(character_->mesh, character_->height)) {}

Result<LiveSurface> LiveSurface::create(std::shared_ptr<const Character> character, const CommandStack& commands,
                                        const Transport& transport) {
  LiveSurface live(std::move(character));
  live.movePose(transport);
  if (const auto updated = live.update(commands); !updated) return updated.error();
  return live;
}

int LiveSurface::depthFor(const SmoothingSettings& settings, float heightPixels) const {
  if (!settings.autoDepth) return settings.depth;
  if (heightPixels > 0.0f) return autoDepth(meanEdge_, heightPixels, depth_);
  return followed_ ? depth_ : settings.depth;
}

Result<bool> LiveSurface::prepareIfChanged(const CommandStack& commands, int depth) {
  if (triedRig_ == commands.revision() && depth_ == depth) return false;
  triedRig_ = commands.revision();
  depth_ = depth;
  Rig rig = commands.rig();
  rig.smoothing.depth = depth;
  const auto start = std::chrono::steady_clock::now();
  const Result<void> prepared = smoother_.prepare(rig);
  prepareSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!prepared) return prepared.error();
  return true;
}

void LiveSurface::movePose(const Transport& transport) {
  if (posed_ && posed_->clip == transport.clip && posed_->time == transport.time) return;
  pose_ = poseAt(transport, *character_);
  posed_ = transport;
  moved_ = true;
}

Result<bool> LiveSurface::update(const CommandStack& commands, const SurfaceView& view) {
  const SmoothingSettings& settings = commands.rig().smoothing;
  const int depth = depthFor(settings, view.heightPixels);
  followed_ = settings.autoDepth && (followed_ || view.heightPixels > 0.0f);
  const Result<bool> prepared = prepareIfChanged(commands, depth);
  if (!prepared && revision_ == 0) return prepared;
  const bool stale = moved_ || eye_ != view.eye || (prepared.ok() && prepared.value());
  if (stale) {
    smoother_.smooth(pose_, surface_, view.eye);
    moved_ = false;
    eye_ = view.eye;
    ++revision_;
  }
  return prepared ? Result<bool>(stale) : prepared;
}

}  // namespace sinew::app
