// core/bodies/place_muscle.h: one muscle of a preset, laid into the flesh of one character.
#pragma once

#include <optional>
#include <string>

#include "core/bodies/fit_preset.h"
#include "core/bodies/flesh.h"

namespace sinew {

/// On the left side or beside the midline. Neither is in a rig yet; the muscle's group is that of the preset.
struct PlacedMuscle {
  Primitive belly;
  std::optional<MuscleLine> line;
};

/// What muscles are placed by.
struct PresetPlace {
  const Character& character;
  const BodyFrame& frame;
  const Flesh& flesh;
  const MirrorPlan& plan;
  const Preset& preset;
  PresetTuning tuning;
};

/// Error: why it cannot be there.
[[nodiscard]] Result<PlacedMuscle> placeMuscle(const PresetPlace& place, const PresetMuscle& muscle);

}  // namespace sinew
