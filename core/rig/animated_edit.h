// core/rig/animated_edit.h: edits of keys, drivers and channels, rig -> rig. Indices must be in range (asserted).
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

/// Number of key tracks of a rig for a clip.
[[nodiscard]] std::size_t countKeyTracks(const Rig& rig, const std::string& clip);

/// Renames the clips of all key tracks. A track already under a new name, of a clip that does not exist, is removed.
/// @param names  old -> new, one to one
[[nodiscard]] Rig withClipsRenamed(Rig rig, const std::map<std::string, std::string>& names);

[[nodiscard]] float& numberIn(Rig& rig, const NumberRef& ref);
[[nodiscard]] float numberOf(const Rig& rig, const NumberRef& ref);
/// Its keys and drivers, or null.
[[nodiscard]] const AnimatedNumber* animationOf(const Rig& rig, const NumberRef& ref);

inline constexpr float kSameKey = 1.0f / 120.0f;  ///< Keys nearer than this are the same key, seconds.

/// Adds or replaces a key. Error: see validateAnimated. @param clip  empty: in every clip
[[nodiscard]] Result<Rig> setKey(Rig rig, const NumberRef& ref, const std::string& clip, float time, float value);
/// Moves key `index` of the clip's track, replacing any key at that time.
[[nodiscard]] Result<Rig> moveKey(Rig rig, const NumberRef& ref, const std::string& clip, int index, float time);
[[nodiscard]] Rig removeKey(Rig rig, const NumberRef& ref, const std::string& clip, int index);
[[nodiscard]] Rig removeKeys(Rig rig, const NumberRef& ref, const std::string& clip);  ///< Removes the clip's track.
/// Adds or replaces the track of its clip.
[[nodiscard]] Result<Rig> setTrack(Rig rig, const NumberRef& ref, const KeyTrack& track);
[[nodiscard]] Result<Rig> setKeyKind(Rig rig, const NumberRef& ref, const std::string& clip, CurveKind kind);

/// Appends, or with an index replaces. Error: see validateAnimated; its line or channel does not exist.
[[nodiscard]] Result<Rig> setDriver(Rig rig, const NumberRef& ref, Driver driver, int index = -1);
[[nodiscard]] Rig removeDriver(Rig rig, const NumberRef& ref, int index);
/// Set driven key: the number is `value` where the input is x. Adds a point to the replacing driver with this input,
/// which is added if there is none. Error: its curve is full.
[[nodiscard]] Result<Rig> setDrivenKey(Rig rig, const NumberRef& ref, const DriverInput& input, float x, float value);
[[nodiscard]] Rig removeAnimation(Rig rig, const NumberRef& ref);  ///< Removes keys and drivers.

/// Index of a channel's track for exactly this clip, or -1.
[[nodiscard]] int findChannel(const Rig& rig, const std::string& name, const std::string& clip);
/// Adds or replaces a key of a channel, which is added if there is none.
[[nodiscard]] Result<Rig> setChannelKey(Rig rig, const std::string& name, const std::string& clip, float time,
                                        float value);
/// Changes a channel's track for exactly this clip. Error: it does not exist, or see validateChannels.
[[nodiscard]] Result<Rig> editChannel(Rig rig, const std::string& name, const std::string& clip,
                                      const std::function<void(Curve&)>& change);
[[nodiscard]] Result<Rig> renameChannel(Rig rig, const std::string& name, const std::string& to);
/// Removes all its tracks and the drivers that read it.
[[nodiscard]] Rig removeChannel(Rig rig, const std::string& name);

/// Removes drivers that read the length of lines that are gone.
void dropLineInputs(Rig& rig, const std::unordered_set<std::string>& gone);
/// Removes drivers for whose input `keep` is false, then numbers without keys and drivers.
template <class Keep>
void keepDrivers(std::vector<AnimatedNumber>& animated, Keep keep) {
  for (AnimatedNumber& number : animated) {
    std::erase_if(number.drivers, [&](const Driver& driver) { return !keep(driver.input); });
  }
  std::erase_if(animated, [](const AnimatedNumber& number) { return number.keys.empty() && number.drivers.empty(); });
}

}  // namespace sinew
