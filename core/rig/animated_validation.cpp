// core/rig/animated_validation.cpp: validates keys, drivers, channels and muscle lines; errors name JSON paths.

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <unordered_set>
#include <utility>

#include <glm/geometric.hpp>

#include "core/rig/validation.h"

namespace sinew {
namespace {

constexpr float kUnitTolerance = 1e-3f;

const char* wordsFor(ParameterOwner owner) {
  constexpr std::array kOwners{"a muscle", "a muscle line", "the surface", "a shape", "a link"};
  return kOwners[static_cast<std::size_t>(owner)];
}

/// @param x, y  JSON paths of the numbers of point i
template <class X, class Y>
Result<void> validatePoints(const std::vector<glm::vec2>& points, const std::string& place, std::size_t most, X x,
                            Y y) {
  if (points.empty()) return errorAt(place, "expected at least one point, got none", "curve");
  if (points.size() > most) {
    return errorAt(place, "expected at most " + std::to_string(most) + " points, got " + std::to_string(points.size()),
                   "curve");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x)) return outOfRange(x(i), "a finite number", points[i].x, "curve");
    if (!std::isfinite(points[i].y)) return outOfRange(y(i), "a finite number", points[i].y, "curve");
    if (i > 0 && !(points[i].x > points[i - 1].x)) {
      return outOfRange(x(i), "a number > " + numberText(points[i - 1].x), points[i].x, "curve");
    }
  }
  return {};
}

Result<void> validateTrack(const KeyTrack& track, const std::string& place) {
  const std::string times = place + ".times";
  const std::string values = place + ".values";
  auto points = validatePoints(
      track.curve.points, times, kMostKeys, [&](std::size_t i) { return times + indexed("", i); },
      [&](std::size_t i) { return values + indexed("", i); });
  if (!points) return points;
  if (track.curve.points.front().x >= 0.0f) return {};
  return outOfRange(times + "[0]", "a time >= 0", track.curve.points.front().x, "key");
}

Result<void> validateTracks(const std::vector<KeyTrack>& tracks, const std::string& place) {
  std::unordered_set<std::string_view> clips;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const std::string own = place + indexed("", i);
    if (auto track = validateTrack(tracks[i], own); !track) return track;
    if (clips.insert(tracks[i].clip).second) continue;
    return errorAt(own + ".clip", "expected one track a clip, but there are two for this one", "keys");
  }
  return {};
}

Result<void> validatePoint(const LineAnchor& anchor, const std::string& place, const char* words) {
  for (int i = 0; i < 3; ++i) {
    if (std::isfinite(anchor.point[i])) continue;
    return outOfRange(place + indexed(".point", static_cast<std::size_t>(i)), "a finite number", anchor.point[i],
                      words);
  }
  return {};
}

Result<void> validateInputAnchor(const LineAnchor& anchor, const std::string& place) {
  auto bone = validateName(anchor.bone, place + ".bone");
  return bone ? validatePoint(anchor, place, "driver") : bone;
}

Result<void> validatePose(const DriverInput& input, const std::string& place) {
  const float length = glm::length(input.rotation);
  if (!(std::abs(length - 1.0f) <= kUnitTolerance)) {
    return outOfRange(place + ".rotation", "a quaternion x, y, z, w of length 1", length, "driver");
  }
  if (input.width >= kLeastPoseWidth && input.width <= kMostPoseWidth) return {};
  return outOfRange(place + ".width", "degrees from 1 to 180", input.width, "driver");
}

Result<void> validateInput(const DriverInput& input, const std::string& place) {
  switch (input.kind) {
    case DriverInputKind::kBend:
    case DriverInputKind::kTwist:
      return validateName(input.bone, place + ".bone");
    case DriverInputKind::kAxis: {
      if (auto bone = validateName(input.bone, place + ".bone"); !bone) return bone;
      const float length = glm::length(input.axis);
      if (std::abs(length - 1.0f) <= kUnitTolerance) return {};
      return outOfRange(place + ".axis", "an axis of length 1", length, "driver");
    }
    case DriverInputKind::kPose:
      if (auto bone = validateName(input.bone, place + ".bone"); !bone) return bone;
      return validatePose(input, place);
    case DriverInputKind::kLength:
      return validateName(input.line, place + ".line");
    case DriverInputKind::kDistance:
      if (auto from = validateInputAnchor(input.from, place + ".from"); !from) return from;
      return validateInputAnchor(input.to, place + ".to");
    case DriverInputKind::kChannel:
      break;
  }
  return validateName(input.channel, place + ".channel");
}

Result<void> validateDriver(const Driver& driver, const std::string& place) {
  if (auto input = validateInput(driver.input, place + ".input"); !input) return input;
  const std::string curve = place + ".curve";
  return validatePoints(
      driver.curve.points, curve, kMostDriverPoints, [&](std::size_t i) { return curve + indexed("", i) + "[0]"; },
      [&](std::size_t i) { return curve + indexed("", i) + "[1]"; });
}

struct KnownNames {
  std::unordered_set<std::string_view> lines;
  std::unordered_set<std::string_view> channels;
};

Result<void> checkInputs(const std::vector<AnimatedNumber>& animated, const KnownNames& known,
                         const std::string& owner) {
  for (std::size_t i = 0; i < animated.size(); ++i) {
    for (std::size_t d = 0; d < animated[i].drivers.size(); ++d) {
      const DriverInput& input = animated[i].drivers[d].input;
      const std::string place = owner + indexed(".animated", i) + indexed(".drivers", d) + ".input";
      if (input.kind == DriverInputKind::kLength && !known.lines.contains(input.line)) {
        return errorAt(place + ".line", "expected the name of a line, but there is no \"" + input.line + '"', "driver");
      }
      if (input.kind == DriverInputKind::kChannel && !known.channels.contains(input.channel)) {
        return errorAt(place + ".channel", "expected the name of a channel, but there is no \"" + input.channel + '"',
                       "driver");
      }
    }
  }
  return {};
}

}  // namespace

Result<void> validateAnimated(const std::vector<AnimatedNumber>& animated, ParameterOwner owner,
                              const std::string& place) {
  std::set<Parameter> known;
  for (std::size_t i = 0; i < animated.size(); ++i) {
    const AnimatedNumber& number = animated[i];
    const std::string own = place + indexed(".animated", i);
    if (ownerOf(number.parameter) != owner) {
      return errorAt(
          own + ".parameter",
          std::string("expected a parameter of ") + wordsFor(owner) + ", got \"" + nameOf(number.parameter) + '"',
          "animated number");
    }
    if (!known.insert(number.parameter).second) {
      return errorAt(
          own + ".parameter",
          std::string("expected each parameter once, but \"") + nameOf(number.parameter) + "\" is there twice",
          "animated number");
    }
    if (auto keys = validateTracks(number.keys, own + ".keys"); !keys) return keys;
    for (std::size_t d = 0; d < number.drivers.size(); ++d) {
      if (auto driver = validateDriver(number.drivers[d], own + indexed(".drivers", d)); !driver) return driver;
    }
  }
  return {};
}

Result<void> validateChannels(const Rig& rig) {
  std::set<std::pair<std::string_view, std::string_view>> known;
  for (std::size_t i = 0; i < rig.channels.size(); ++i) {
    const RigChannel& channel = rig.channels[i];
    const std::string place = indexed("channels", i);
    const std::string subject = "channel " + std::to_string(i + 1);
    if (auto name = validateName(channel.name, place + ".name"); !name) return about(subject, name.error());
    if (auto track = validateTrack(channel.track, place); !track) return about(subject, track.error());
    if (known.emplace(channel.name, channel.track.clip).second) continue;
    return errorAt(place + ".clip", "expected one track a clip, but \"" + channel.name + "\" has two for this one",
                   subject);
  }
  return {};
}

Result<void> validateInputs(const Rig& rig) {
  KnownNames known;
  for (const MuscleLine& line : rig.lines) known.lines.insert(line.name);
  for (const RigChannel& channel : rig.channels) known.channels.insert(channel.name);
  if (auto surface = checkInputs(rig.surface.animated, known, "surface"); !surface) return surface;
  for (std::size_t i = 0; i < rig.lines.size(); ++i) {
    auto line = checkInputs(rig.lines[i].animated, known, indexed("lines", i));
    if (!line) return about(quoted("muscle line", rig.lines[i].name), line.error());
  }
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    auto primitive = checkInputs(rig.primitives[i].animated, known, indexed("primitives", i));
    if (!primitive) return about(quoted("muscle", rig.primitives[i].name), primitive.error());
  }
  for (std::size_t i = 0; i < rig.morphs.size(); ++i) {
    auto morph = checkInputs(rig.morphs[i].animated, known, indexed("shapes", i));
    if (!morph) return about(quoted("shape", rig.morphs[i].name), morph.error());
  }
  for (std::size_t i = 0; i < rig.links.size(); ++i) {
    auto link = checkInputs(rig.links[i].animated, known, indexed("links", i));
    if (!link) return about("link " + std::to_string(i + 1), link.error());
  }
  return {};
}

namespace {

/// A number of a line and its range.
struct LineNumber {
  const char* key;
  const char* words;
  float value;
  float least;
  float most;
};

}  // namespace

Result<void> validateSettings(const LineSettings& line, const std::string& place) {
  const std::array numbers = {
      LineNumber{".rest", "rest length", line.rest, kLeastRest, kMostRest},
      LineNumber{".tendons[0]", "origin tendon", line.tendons.x, 0.0f, kMostTendons},
      LineNumber{".tendons[1]", "insertion tendon", line.tendons.y, 0.0f, kMostTendons},
      LineNumber{".tendons", "both tendons together", line.tendons.x + line.tendons.y, 0.0f, kMostTendons},
      LineNumber{".volume", "volume", line.volume, 0.0f, kMostVolume},
      LineNumber{".pivot", "pivot", line.pivot, 0.0f, 1.0f},
      LineNumber{".twist", "twist", line.twist, 0.0f, 1.0f},
      LineNumber{".flex[0]", "flex height", line.flex.x, kLeastFlex, kMostFlex},
      LineNumber{".flex[1]", "flex width", line.flex.y, kLeastFlex, kMostFlex},
      LineNumber{".activation.base", "activation", line.base, 0.0f, 1.0f},
      LineNumber{".activation.gain", "activation gain", line.gain, 0.0f, kMostGain},
      LineNumber{".activation.full", "full contraction", line.full, kLeastFull, kMostFull},
  };
  for (const auto& [key, words, value, least, most] : numbers) {
    if (value >= least && value <= most) continue;
    return outOfRange(place + key, "a number from " + numberText(least) + " to " + numberText(most), value, words);
  }
  if (!(line.limits.x > 0.0f && line.limits.x < 1.0f)) {
    return outOfRange(place + ".limits[0]", "a number > 0 and < 1", line.limits.x, "least stretch");
  }
  if (!(line.limits.y > 1.0f && std::isfinite(line.limits.y))) {
    return outOfRange(place + ".limits[1]", "a number > 1", line.limits.y, "most stretch");
  }
  return {};
}

Result<void> validateAnchor(const LineAnchor& anchor, const std::string& place, const char* words) {
  if (auto bone = validateName(anchor.bone, place + ".bone"); !bone) return named(words, bone.error());
  return validatePoint(anchor, place, words);
}

namespace {

Result<void> validateLineParts(const MuscleLine& line, const std::string& place) {
  if (auto name = validateName(line.name, place + ".name"); !name) return name;
  if (auto origin = validateAnchor(line.origin, place + ".origin", "origin"); !origin) return origin;
  if (auto insertion = validateAnchor(line.insertion, place + ".insertion", "insertion"); !insertion) return insertion;
  if (line.via) {
    if (auto via = validateAnchor(*line.via, place + ".via", "via point"); !via) return via;
  }
  if (auto settings = validateSettings(line.settings, place); !settings) return settings;
  return validateAnimated(line.animated, ParameterOwner::kLine, place);
}

}  // namespace

Result<void> validateLine(const MuscleLine& line, const std::string& place) {
  if (auto parts = validateLineParts(line, place); !parts) {
    return about(line.name.empty() ? "a muscle line" : quoted("muscle line", line.name), parts.error());
  }
  return {};
}

}  // namespace sinew
