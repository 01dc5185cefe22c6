// core/bodies/preset_from_muscles.h: muscles of one character as marks, so that they fit any: the way back from
// fit_preset.h.
#pragma once

#include <span>
#include <vector>

#include "core/bodies/fit_preset.h"

namespace sinew {

struct PresetOfMuscles {
  Preset preset;  ///< Without name and title.
  std::vector<FittedPreset::LeftOut> leftOut;
};

/// Of twins one counts: fitting makes the other. What is on one side alone becomes a pair; what lies across the middle
/// stays single. Left out is what is on a bone that is no part of the body, on a hand, foot or head whose length is not
/// known, or has no skin over it. Keys, drivers, territories and the
/// activation by hand stay behind. Error: the body is unknown, or nothing is left.
/// @param primitives  rig indices
[[nodiscard]] Result<PresetOfMuscles> presetFromMuscles(const Rig& rig, std::span<const int> primitives,
                                                        const Character& character, const MirrorPlan& plan);

}  // namespace sinew
