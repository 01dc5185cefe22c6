// core/bodies/fit_preset.h: the muscles of a preset on a character.
#pragma once

#include <string>
#include <vector>

#include "core/bodies/preset.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

inline constexpr float kLeastMass = 0.5f;
inline constexpr float kMostMass = 2.0f;

/// The two numbers that a whole set is tuned by.
struct PresetTuning {
  float mass = 1.0f;                ///< Girth, kLeastMass..kMostMass.
  std::optional<float> definition;  ///< How far bellies stand out of the flesh, 0..1; nullopt: the preset's.
};

struct FittedPreset {
  struct LeftOut {
    std::string name;  ///< Of the muscle.
    std::string why;
  };
  Rig rig;  ///< The rig with the muscles at the end of its primitives.
  std::vector<std::string> muscles;
  std::vector<LeftOut> leftOut;
};

/// Places every muscle where its marks lie on this body, with its twin, its groups and its line; lines learn their
/// lengths from the clips and the range of motion. Error: the body is of another kind, or the rig takes no more.
/// @param character  with the range of motion as a clip (withRangeOfMotion)
[[nodiscard]] Result<FittedPreset> fitPreset(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                             const Character& character, const MirrorPlan& plan);

}  // namespace sinew
