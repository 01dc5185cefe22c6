// core/rig/animated_edit.h: changes of keys, drivers and channels, as pure functions rig -> rig.
//
// As in rig_edit.h: a rig is taken by value; indices must be in range (asserted).
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <unordered_set>

#include "core/rig/rig_edit.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

// Keys of whole clips, of all numbers and channels of a rig.

/// Key tracks that a rig has in the clip of that name.
[[nodiscard]] std::size_t countKeyTracks(const Rig& rig, const std::string& clip);

/// The rig whose keys follow clips that are called otherwise from now on. A track that had one of the new names for a
/// clip that is not there gives way.
/// @param names  from old to new; no two become the same
[[nodiscard]] Rig withClipsRenamed(Rig rig, const std::map<std::string, std::string>& names);

[[nodiscard]] float& numberIn(Rig& rig, const NumberRef& ref);
[[nodiscard]] float numberOf(const Rig& rig, const NumberRef& ref);
/// Its keys and drivers, or null.
[[nodiscard]] const AnimatedNumber* animationOf(const Rig& rig, const NumberRef& ref);

/// Keys nearer than this are one key, seconds.
inline constexpr float kSameKey = 1.0f / 120.0f;

/// A key at a time of a clip, in place of one that is there. Error: see validateAnimated.
/// @param clip  empty: in every clip
[[nodiscard]] Result<Rig> setKey(Rig rig, const NumberRef& ref, const std::string& clip, float time, float value);
/// Moves key `index` of the clip's track; one that is there already gives way.
[[nodiscard]] Result<Rig> moveKey(Rig rig, const NumberRef& ref, const std::string& clip, int index, float time);
[[nodiscard]] Rig removeKey(Rig rig, const NumberRef& ref, const std::string& clip, int index);
/// The clip's whole track.
[[nodiscard]] Rig removeKeys(Rig rig, const NumberRef& ref, const std::string& clip);
/// The whole track of its clip, in place of one that is there.
[[nodiscard]] Result<Rig> setTrack(Rig rig, const NumberRef& ref, const KeyTrack& track);
[[nodiscard]] Result<Rig> setKeyKind(Rig rig, const NumberRef& ref, const std::string& clip, CurveKind kind);

/// Appends, or with an index replaces. Error: see validateAnimated; its line or channel is not there.
[[nodiscard]] Result<Rig> setDriver(Rig rig, const NumberRef& ref, Driver driver, int index = -1);
[[nodiscard]] Rig removeDriver(Rig rig, const NumberRef& ref, int index);
/// Set driven key: where the input is x, the number is `value`. A point of the driver that replaces by this input,
/// which is made where there is none. Error: its curve is full.
[[nodiscard]] Result<Rig> setDrivenKey(Rig rig, const NumberRef& ref, const DriverInput& input, float x, float value);
/// Neither keys nor drivers any more.
[[nodiscard]] Rig removeAnimation(Rig rig, const NumberRef& ref);

/// The index of a channel's track for exactly this clip, or -1.
[[nodiscard]] int findChannel(const Rig& rig, const std::string& name, const std::string& clip);
/// A key of a channel, which is made where there is none.
[[nodiscard]] Result<Rig> setChannelKey(Rig rig, const std::string& name, const std::string& clip, float time,
                                        float value);
/// Changes a channel's track for exactly this clip. Error: it is not there, or see validateChannels.
[[nodiscard]] Result<Rig> editChannel(Rig rig, const std::string& name, const std::string& clip,
                                      const std::function<void(Curve&)>& change);
[[nodiscard]] Result<Rig> renameChannel(Rig rig, const std::string& name, const std::string& to);
/// All its tracks, and the drivers that read it.
[[nodiscard]] Rig removeChannel(Rig rig, const std::string& name);

/// Drivers that read the length of lines that are gone go too.
void dropLineInputs(Rig& rig, const std::unordered_set<std::string>& gone);
/// Drivers whose input `keep` refuses go, and numbers that nothing changes any more.
template <class Keep>
void keepDrivers(std::vector<AnimatedNumber>& animated, Keep keep) {
  for (AnimatedNumber& number : animated) {
    std::erase_if(number.drivers, [&](const Driver& driver) { return !keep(driver.input); });
  }
  std::erase_if(animated, [](const AnimatedNumber& number) { return number.keys.empty() && number.drivers.empty(); });
}

}  // namespace sinew
