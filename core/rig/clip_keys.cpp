// core/rig/clip_keys.cpp: keys of whole clips, of all numbers and channels of a rig.
#include "core/rig/clip_keys.h"

#include <algorithm>
#include <set>
#include <vector>

namespace sinew {
namespace {

/// Calls visit(std::vector<AnimatedNumber>&) for every owner of numbers.
template <class AnyRig, class Visit>
void eachOwner(AnyRig& rig, Visit visit) {
  for (auto& primitive : rig.primitives) visit(primitive.animated);
  for (auto& line : rig.lines) visit(line.animated);
  for (auto& morph : rig.morphs) visit(morph.animated);
  visit(rig.surface.animated);
}

/// What becomes of a track.
class Renaming {
 public:
  explicit Renaming(const std::map<std::string, std::string>& names) : names_(names) {
    for (const auto& [before, after] : names) taken_.insert(after);
  }

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
  eachOwner(rig, [&](const std::vector<AnimatedNumber>& animated) {
    for (const AnimatedNumber& number : animated) {
      count += static_cast<std::size_t>(std::ranges::count(number.keys, clip, &KeyTrack::clip));
    }
  });
  for (const RigChannel& channel : rig.channels) count += channel.track.clip == clip ? 1 : 0;
  return count;
}

Rig withClipsRenamed(Rig rig, const std::map<std::string, std::string>& names) {
  const Renaming renaming(names);
  eachOwner(rig, [&](std::vector<AnimatedNumber>& animated) {
    for (AnimatedNumber& number : animated) {
      std::erase_if(number.keys, [&](const KeyTrack& track) { return renaming.givesWay(track); });
      for (KeyTrack& track : number.keys) renaming.rename(track);
    }
    std::erase_if(animated, [](const AnimatedNumber& number) { return number.keys.empty() && number.drivers.empty(); });
  });
  // A channel keeps its last track: drivers read it.
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

}  // namespace sinew
