// core/rig/animated_number.cpp: names, and which track counts.
#include "sinew/rig/animated_number.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace sinew {
namespace {

template <class Kind, std::size_t N>
using Names = std::array<std::pair<Kind, const char*>, N>;

constexpr Names<CurveKind, 3> kCurves{
    {{CurveKind::kSmooth, "smooth"}, {CurveKind::kLinear, "linear"}, {CurveKind::kStep, "step"}}};
constexpr Names<DriverInputKind, 7> kInputs{{{DriverInputKind::kBend, "bend"},
                                             {DriverInputKind::kTwist, "twist"},
                                             {DriverInputKind::kAxis, "axis"},
                                             {DriverInputKind::kPose, "pose"},
                                             {DriverInputKind::kLength, "length"},
                                             {DriverInputKind::kDistance, "distance"},
                                             {DriverInputKind::kChannel, "channel"}}};
constexpr Names<DriverMode, 3> kModes{
    {{DriverMode::kAdd, "add"}, {DriverMode::kMultiply, "multiply"}, {DriverMode::kReplace, "replace"}}};

template <class Kind, std::size_t N>
const char* nameIn(const Names<Kind, N>& names, Kind kind) {
  return std::ranges::find(names, kind, &std::pair<Kind, const char*>::first)->second;
}

template <class Kind, std::size_t N>
std::optional<Kind> named(const Names<Kind, N>& names, const std::string& name) {
  const auto found = std::ranges::find_if(names, [&](const auto& row) { return name == row.second; });
  return found == names.end() ? std::nullopt : std::optional(found->first);
}

}  // namespace

const char* nameOf(CurveKind kind) { return nameIn(kCurves, kind); }
const char* nameOf(DriverInputKind kind) { return nameIn(kInputs, kind); }
const char* nameOf(DriverMode mode) { return nameIn(kModes, mode); }
std::optional<CurveKind> curveKindNamed(const std::string& name) { return named(kCurves, name); }
std::optional<DriverInputKind> driverInputKindNamed(const std::string& name) { return named(kInputs, name); }
std::optional<DriverMode> driverModeNamed(const std::string& name) { return named(kModes, name); }

const AnimatedNumber* animationOf(const std::vector<AnimatedNumber>& animated, Parameter parameter) {
  const auto found = std::ranges::find(animated, parameter, &AnimatedNumber::parameter);
  return found == animated.end() ? nullptr : &*found;
}

const KeyTrack* trackIn(const std::vector<KeyTrack>& tracks, const std::string& clip) {
  if (clip.empty()) return nullptr;
  const KeyTrack* everywhere = nullptr;
  for (const KeyTrack& track : tracks) {
    if (track.clip == clip) return &track;
    if (track.clip.empty()) everywhere = &track;
  }
  return everywhere;
}

}  // namespace sinew
