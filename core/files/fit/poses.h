// core/files/fit/poses.h: the poses that an export is fitted to and measured in.
#pragma once

#include <string>
#include <vector>

#include "sinew/character/character.h"

namespace sinew::exporting {

inline constexpr int kMeasuredPerSecond = 30;
inline constexpr int kFurtherPerSecond = 10;
inline constexpr double kSameTime = 1e-3;  ///< Share of a frame: times no farther apart are one.
inline constexpr int kHeldOutEvery = 5;    ///< A fifth of what could be fitted is kept from the fit.

/// What a pose is for.
enum class PoseUse { kMeasured, kFitted, kHeldOut };

struct ExportPose {
  int clip = 0;  ///< Index in the character that has them all.
  float time = 0.0f;
  PoseUse use = PoseUse::kMeasured;
};

/// Times of a clip, seconds: so many a second from its start on, then its end.
[[nodiscard]] std::vector<float> clipTimes(const AnimationClip& clip, double perSecond);

/// Clips at 30 poses a second and at their ends. All of them are fitted or held out where the clips are short; where
/// they are long, every second or third. Further clips at 10 poses a second, all fitted or held out.
/// @param clips    of the exported file: indices into character.clips
/// @param further  clips that are fitted to but not exported, likewise
[[nodiscard]] std::vector<ExportPose> exportPoses(const Character& character, const std::vector<int>& clips,
                                                  const std::vector<int>& further);

}  // namespace sinew::exporting
