// core/rig/animated_edit.cpp: edits keys, drivers and channels and validates what has changed.
#include "core/rig/animated_edit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "core/geometry/at.h"
#include "core/rig/references.h"
#include "core/rig/validation.h"

namespace sinew {
namespace {

/// Calls visit(std::vector<AnimatedNumber>&) for every owner of numbers.
template <class AnyRig, class Visit>
void eachList(AnyRig& rig, Visit visit) {
  for (auto& primitive : rig.primitives) visit(primitive.animated);
  for (auto& line : rig.lines) visit(line.animated);
  for (auto& morph : rig.morphs) visit(morph.animated);
  for (auto& link : rig.links) visit(link.animated);
  visit(rig.surface.animated);
}

void dropIdle(std::vector<AnimatedNumber>& animated) {
  keepDrivers(animated, [](const DriverInput&) { return true; });
}

class Renaming {
 public:
  explicit Renaming(const std::map<std::string, std::string>& names) : names_(names) {
    for (const auto& [before, after] : names) taken_.insert(after);
  }

  /// Its clip does not exist, but another clip gets the name.
  [[nodiscard]] bool givesWay(const KeyTrack& track) const {
    return taken_.contains(track.clip) && !names_.contains(track.clip);
  }
  void rename(KeyTrack& track) const {
    const auto found = names_.find(track.clip);
    if (found != names_.end()) track.clip = found->second;
  }

 private:
  const std::map<std::string, std::string>& names_;
  std::set<std::string> taken_;
};

}  // namespace

std::size_t countKeyTracks(const Rig& rig, const std::string& clip) {
  std::size_t count = 0;
  eachList(rig, [&](const std::vector<AnimatedNumber>& animated) {
    for (const AnimatedNumber& number : animated) {
      count += static_cast<std::size_t>(std::ranges::count(number.keys, clip, &KeyTrack::clip));
    }
  });
  for (const RigChannel& channel : rig.channels) count += channel.track.clip == clip ? 1 : 0;
  return count;
}

Rig withClipsRenamed(Rig rig, const std::map<std::string, std::string>& names) {
  const Renaming renaming(names);
  eachList(rig, [&](std::vector<AnimatedNumber>& animated) {
    for (AnimatedNumber& number : animated) {
      std::erase_if(number.keys, [&](const KeyTrack& track) { return renaming.givesWay(track); });
      for (KeyTrack& track : number.keys) renaming.rename(track);
    }
    dropIdle(animated);
  });
  // A channel keeps its last track, since drivers read it.
  const auto isAnothers = [&](const RigChannel& channel) {
    return renaming.givesWay(channel.track) && std::ranges::any_of(rig.channels, [&](const RigChannel& other) {
             return other.name == channel.name && !renaming.givesWay(other.track);
           });
  };
  std::vector<RigChannel> kept;
  for (const RigChannel& channel : rig.channels) {
    if (!isAnothers(channel)) kept.push_back(channel);
  }
  for (RigChannel& channel : kept) renaming.rename(channel.track);
  rig.channels = std::move(kept);
  return rig;
}

namespace {

std::vector<AnimatedNumber>& listOf(Rig& rig, const NumberRef& ref) {
  switch (ownerOf(ref.parameter)) {
    case ParameterOwner::kPrimitive:
      return at(rig.primitives, ref.owner).animated;
    case ParameterOwner::kLine:
      return at(rig.lines, ref.owner).animated;
    case ParameterOwner::kMorph:
      return at(rig.morphs, ref.owner).animated;
    case ParameterOwner::kLink:
      return at(rig.links, ref.owner).animated;
    case ParameterOwner::kSurface:
      break;
  }
  return rig.surface.animated;
}

std::string placeOf(const NumberRef& ref) {
  const auto index = static_cast<std::size_t>(ref.owner);
  switch (ownerOf(ref.parameter)) {
    case ParameterOwner::kPrimitive:
      return indexed("primitives", index);
    case ParameterOwner::kLine:
      return indexed("lines", index);
    case ParameterOwner::kMorph:
      return indexed("shapes", index);
    case ParameterOwner::kLink:
      return indexed("links", index);
    case ParameterOwner::kSurface:
      break;
  }
  return "surface";
}

/// Changes the entry of a number, which is added if there is none and removed if nothing is left of it.
template <class Change>
Result<Rig> withNumber(Rig rig, const NumberRef& ref, Change change) {
  std::vector<AnimatedNumber>& animated = listOf(rig, ref);
  auto found = std::ranges::find(animated, ref.parameter, &AnimatedNumber::parameter);
  if (found == animated.end()) {
    animated.push_back({ref.parameter, {}, {}, {}});
    found = animated.end() - 1;
  }
  change(*found);
  dropIdle(animated);
  if (auto valid = validateAnimated(animated, ownerOf(ref.parameter), placeOf(ref)); !valid) return valid.error();
  if (auto inputs = validateInputs(rig); !inputs) return inputs.error();
  return rig;
}

/// An edit that needs no validation.
template <class Change>
Rig withLess(Rig rig, const NumberRef& ref, Change change) {
  std::vector<AnimatedNumber>& animated = listOf(rig, ref);
  const auto found = std::ranges::find(animated, ref.parameter, &AnimatedNumber::parameter);
  if (found == animated.end()) return rig;
  change(*found);
  dropIdle(animated);
  return rig;
}

KeyTrack& trackOf(std::vector<KeyTrack>& tracks, const std::string& clip) {
  const auto found = std::ranges::find(tracks, clip, &KeyTrack::clip);
  if (found != tracks.end()) return *found;
  tracks.push_back({clip, {}, {}});
  return tracks.back();
}

/// Inserts a point in order, replacing those nearer than `same`.
void put(std::vector<glm::vec2>& points, const glm::vec2& point, float same) {
  std::erase_if(points, [&](const glm::vec2& other) { return std::abs(other.x - point.x) < same; });
  points.insert(std::ranges::upper_bound(points, point.x, {}, [](const glm::vec2& p) { return p.x; }), point);
}

/// Distance below which two inputs of driven keys are the same, in the input's units.
float sameInput(DriverInputKind kind) {
  switch (kind) {
    case DriverInputKind::kBend:
    case DriverInputKind::kTwist:
    case DriverInputKind::kAxis:
      return 0.5f;  // Degrees.
    default:
      return 0.005f;
  }
}

}  // namespace

float& numberIn(Rig& rig, const NumberRef& ref) {
  float* number = nullptr;
  switch (ownerOf(ref.parameter)) {
    case ParameterOwner::kPrimitive:
      number = numberIn(at(rig.primitives, ref.owner), ref.parameter);
      break;
    case ParameterOwner::kLine:
      number = numberIn(at(rig.lines, ref.owner).settings, ref.parameter);
      break;
    case ParameterOwner::kMorph:
      number = numberIn(at(rig.morphs, ref.owner), ref.parameter);
      break;
    case ParameterOwner::kLink:
      number = numberIn(at(rig.links, ref.owner), ref.parameter);
      break;
    case ParameterOwner::kSurface:
      number = numberIn(rig.surface, ref.parameter);
      break;
  }
  assert(number);
  return *number;
}

float numberOf(const Rig& rig, const NumberRef& ref) {
  return numberIn(const_cast<Rig&>(rig), ref);  // Only reads.
}

const AnimatedNumber* animationOf(const Rig& rig, const NumberRef& ref) {
  return animationOf(listOf(const_cast<Rig&>(rig), ref), ref.parameter);
}

Result<Rig> setKey(Rig rig, const NumberRef& ref, const std::string& clip, float time, float value) {
  return withNumber(std::move(rig), ref, [&](AnimatedNumber& number) {
    put(trackOf(number.keys, clip).curve.points, {time, value}, kSameKey);
  });
}

Result<Rig> moveKey(Rig rig, const NumberRef& ref, const std::string& clip, int index, float time) {
  return withNumber(std::move(rig), ref, [&](AnimatedNumber& number) {
    std::vector<glm::vec2>& points = trackOf(number.keys, clip).curve.points;
    const float value = at(points, index).y;
    points.erase(points.begin() + index);
    put(points, {time, value}, kSameKey);
  });
}

Rig removeKey(Rig rig, const NumberRef& ref, const std::string& clip, int index) {
  return withLess(std::move(rig), ref, [&](AnimatedNumber& number) {
    std::vector<glm::vec2>& points = trackOf(number.keys, clip).curve.points;
    assert(index >= 0 && static_cast<std::size_t>(index) < points.size());
    points.erase(points.begin() + index);
    std::erase_if(number.keys, [](const KeyTrack& track) { return track.curve.points.empty(); });
  });
}

Rig removeKeys(Rig rig, const NumberRef& ref, const std::string& clip) {
  return withLess(std::move(rig), ref, [&](AnimatedNumber& number) {
    std::erase_if(number.keys, [&](const KeyTrack& track) { return track.clip == clip; });
  });
}

Result<Rig> setTrack(Rig rig, const NumberRef& ref, const KeyTrack& track) {
  return withNumber(std::move(rig), ref, [&](AnimatedNumber& number) { trackOf(number.keys, track.clip) = track; });
}

Result<Rig> setKeyKind(Rig rig, const NumberRef& ref, const std::string& clip, CurveKind kind) {
  return withNumber(std::move(rig), ref, [&](AnimatedNumber& number) { trackOf(number.keys, clip).curve.kind = kind; });
}

Result<Rig> setDriver(Rig rig, const NumberRef& ref, Driver driver, int index) {
  return withNumber(std::move(rig), ref, [&](AnimatedNumber& number) {
    if (index < 0) number.drivers.push_back(std::move(driver));
    else at(number.drivers, index) = std::move(driver);
  });
}

Rig removeDriver(Rig rig, const NumberRef& ref, int index) {
  return withLess(std::move(rig), ref, [&](AnimatedNumber& number) {
    assert(index >= 0 && static_cast<std::size_t>(index) < number.drivers.size());
    number.drivers.erase(number.drivers.begin() + index);
  });
}

Result<Rig> setDrivenKey(Rig rig, const NumberRef& ref, const DriverInput& input, float x, float value) {
  return withNumber(std::move(rig), ref, [&](AnimatedNumber& number) {
    auto found = std::ranges::find_if(number.drivers, [&](const Driver& driver) {
      return driver.mode == DriverMode::kReplace && driver.input == input;
    });
    if (found == number.drivers.end()) {
      number.drivers.push_back({input, {}, DriverMode::kReplace, {}});
      found = number.drivers.end() - 1;
    }
    put(found->curve.points, {x, value}, sameInput(input.kind));
  });
}

Rig removeAnimation(Rig rig, const NumberRef& ref) {
  return withLess(std::move(rig), ref, [](AnimatedNumber& number) {
    number.keys.clear();
    number.drivers.clear();
  });
}

int findChannel(const Rig& rig, const std::string& name, const std::string& clip) {
  const auto found = std::ranges::find_if(
      rig.channels, [&](const RigChannel& channel) { return channel.name == name && channel.track.clip == clip; });
  return found == rig.channels.end() ? -1 : static_cast<int>(found - rig.channels.begin());
}

Result<Rig> setChannelKey(Rig rig, const std::string& name, const std::string& clip, float time, float value) {
  int index = findChannel(rig, name, clip);
  if (index < 0) {
    index = static_cast<int>(rig.channels.size());
    rig.channels.push_back({name, {clip, {}, {}}});
  }
  put(at(rig.channels, index).track.curve.points, {time, value}, kSameKey);
  if (auto valid = validateChannels(rig); !valid) return valid.error();
  return rig;
}

Result<Rig> editChannel(Rig rig, const std::string& name, const std::string& clip,
                        const std::function<void(Curve&)>& change) {
  const int index = findChannel(rig, name, clip);
  if (index < 0) return errorAt("channels", "there is no channel \"" + name + "\" for this clip", "channel");
  change(at(rig.channels, index).track.curve);
  if (auto valid = validateChannels(rig); !valid) return valid.error();
  return rig;
}

Result<Rig> renameChannel(Rig rig, const std::string& name, const std::string& to) {
  if (auto valid = validateName(to, "channels"); !valid) return valid.error();
  const auto taken = std::ranges::any_of(rig.channels, [&](const RigChannel& channel) { return channel.name == to; });
  if (taken && to != name) return errorAt("channels", "the name \"" + to + "\" is taken", "name");
  for (RigChannel& channel : rig.channels) {
    if (channel.name == name) channel.name = to;
  }
  renameReferences(rig, Named::kChannel, name, to);
  return rig;
}

Rig removeChannel(Rig rig, const std::string& name) {
  std::erase_if(rig.channels, [&](const RigChannel& channel) { return channel.name == name; });
  eachList(rig, [&](std::vector<AnimatedNumber>& animated) {
    keepDrivers(animated, [&](const DriverInput& input) {
      return input.kind != DriverInputKind::kChannel || input.channel != name;
    });
  });
  return rig;
}

void dropLineInputs(Rig& rig, const std::unordered_set<std::string>& gone) {
  eachList(rig, [&](std::vector<AnimatedNumber>& animated) {
    keepDrivers(animated, [&](const DriverInput& input) {
      return input.kind != DriverInputKind::kLength || !gone.contains(input.line);
    });
  });
}

}  // namespace sinew
