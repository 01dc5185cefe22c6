// core/bodies/fit_preset.h: the muscles of a preset on a character.
#pragma once

#include <string>
#include <vector>

#include "core/bodies/body_frame.h"
#include "core/bodies/preset.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

// Where a point lies about the axis of a part of the body.

/// Cylinder coordinates round an axis that may have bends.
struct PartPlace {
  float u = 0.0f;       ///< Along the part, as Mark::u.
  float angle = 0.0f;   ///< Degrees, as Mark::angle. 0 on the axis, where there is none.
  float away = 0.0f;    ///< From the axis.
  float beside = 0.0f;  ///< Along the part from the level of u: not 0 where a bend of the axis leaves no level.
};

/// Of H: so near the axis there is no angle.
inline constexpr float kOnAxis = 1e-5f;

/// @param leastAway  nearer than this there is no angle
[[nodiscard]] PartPlace placeAt(const PartAxis& axis, const glm::vec3& point, float leastAway);

/// Unit axes there: away from the axis, round it, along it.
[[nodiscard]] glm::mat3 axesAt(const PartAxis& axis, float u, float angle);

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
