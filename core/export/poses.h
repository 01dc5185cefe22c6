// core/export/poses.h: the poses that an export is fitted to and measured in.
#pragma once

#include <string>
#include <vector>

#include "sinew/character/character.h"

namespace sinew::exporting {

inline constexpr int kMeasuredPerSecond = 30;
inline constexpr int kFittedEvery = 3;   ///< Of the measured poses: 10 a second.
inline constexpr int kHeldOutEvery = 5;  ///< Of those: a fifth is kept from the fit.

/// What a pose is for.
enum class PoseUse { kMeasured, kFitted, kHeldOut };

struct ExportPose {
  int clip = 0;  ///< Of the character that has them all.
  float time = 0.0f;
  PoseUse use = PoseUse::kMeasured;
};

/// Clips at 30 poses a second, every third of them fitted or held out; further clips at 10 a second, all of which are.
/// @param clips    of the exported file: indices into character.clips
/// @param further  clips that are fitted to but not exported, likewise
[[nodiscard]] std::vector<ExportPose> exportPoses(const Character& character, const std::vector<int>& clips,
                                                  const std::vector<int>& further);

}  // namespace sinew::exporting
