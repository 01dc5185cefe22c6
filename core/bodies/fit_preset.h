// core/bodies/fit_preset.h: places the muscles of a preset on a character.
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

/// Cylindrical coordinates about the axis of a body part, which may have bends.
struct PartPlace {
  float u = 0.0f;       ///< Along the part, as Mark::u.
  float angle = 0.0f;   ///< Degrees, as Mark::angle; 0 on the axis.
  float away = 0.0f;    ///< Distance from the axis.
  float beside = 0.0f;  ///< Distance along the part from the level of u: not 0 where no level passes through the point.
};

inline constexpr float kOnAxis = 1e-5f;  ///< Distance from the axis below which there is no angle, fraction of H.

/// @param leastAway  distance from the axis below which the angle is 0
[[nodiscard]] PartPlace placeAt(const PartAxis& axis, const glm::vec3& point, float leastAway);

/// Unit vectors at a place: away from the axis, around it, along it.
[[nodiscard]] glm::mat3 axesAt(const PartAxis& axis, float u, float angle);

inline constexpr float kLeastMass = 0.5f;
inline constexpr float kMostMass = 2.0f;

/// Adjusts a whole set.
struct PresetTuning {
  float mass = 1.0f;                ///< Factor on girth, kLeastMass..kMostMass.
  std::optional<float> definition;  ///< How far bellies stand out of the skin, 0..1; nullopt: the preset's.
};

struct FittedPreset {
  struct LeftOut {
    std::string name;
    std::string why;
  };
  Rig rig;  ///< With the muscles at the end of its primitives.
  std::vector<std::string> muscles;
  std::vector<LeftOut> leftOut;
};

/// Places every muscle where its marks lie on this body, with its twin, groups and line. Lines learn their lengths from
/// the clips and the range of motion. Error: the body is of another kind, or no muscle finds a place.
/// @param character  with the range of motion as a clip (withRangeOfMotion)
[[nodiscard]] Result<FittedPreset> fitPreset(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                             const Character& character, const MirrorPlan& plan);

}  // namespace sinew
