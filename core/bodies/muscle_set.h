// core/bodies/muscle_set.h: a set of muscles added to a rig: placed, learned and mended in one go.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/bodies/fit_preset.h"
#include "core/bodies/mend.h"
#include "core/bodies/motions.h"

namespace sinew {

struct AddedSet {
  FittedPreset fitted;
  std::vector<std::string> mended;  ///< Of each line that was changed: "calf L: pivot 0.3".
};

/// fitPreset(), then what check() finds of the set's own muscles is mended (mend_rig.h), and what nothing mends is left
/// out; those that were there before are their designer's. In a rig without muscles the set decides how much muscle
/// skins blend. Errors as of fitPreset().
/// @param motions  of the character with the range of motion as a clip
[[nodiscard]] Result<AddedSet> addMuscleSet(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                            const Motions& motions, const MirrorPlan& plan);

/// The same without mending, which takes longest: for a slider that is being dragged.
[[nodiscard]] Result<FittedPreset> addMuscleSetQuickly(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                                       const Motions& motions, const MirrorPlan& plan);

}  // namespace sinew
