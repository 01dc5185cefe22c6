// app/playback.cpp: clip time -> pose -> surface.

#include "app/playback.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

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
    : character_(std::move(character)), smoother_(character_) {}

Result<LiveSurface> LiveSurface::create(std::shared_ptr<const Character> character, const CommandStack& commands,
                                        const Transport& transport) {
  LiveSurface live(std::move(character));
  live.movePose(transport);
  if (const auto updated = live.update(commands); !updated) return updated.error();
  return live;
}

Result<bool> LiveSurface::prepareIfEdited(const CommandStack& commands) {
  if (triedRig_ == commands.revision()) return false;
  triedRig_ = commands.revision();
  const auto start = std::chrono::steady_clock::now();
  const Result<void> prepared = smoother_.prepare(commands.rig());
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

Result<bool> LiveSurface::update(const CommandStack& commands) {
  const Result<bool> prepared = prepareIfEdited(commands);
  if (!prepared && revision_ == 0) return prepared;
  const bool stale = moved_ || (prepared.ok() && prepared.value());
  if (stale) {
    smoother_.smooth(pose_, surface_);
    moved_ = false;
    ++revision_;
  }
  return prepared ? Result<bool>(stale) : prepared;
}

}  // namespace sinew::app
