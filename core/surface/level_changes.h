// core/surface/level_changes.h: where an edit can have changed what adaptive detail sees. docs/design.md, Detail.
#pragma once

#include <memory>
#include <vector>

#include "core/surface/preparation.h"
#include "sinew/character/pose.h"

namespace sinew {

/// The muscles of a rig in one pose.
struct LevelMuscles {
  std::vector<PosedPrimitive> primitives;  ///< [A] world; hidden ones too.
  float skinBlend = 0.0f;
};

/// All that levels follow from, beside the character.
struct LevelSources {
  std::shared_ptr<const Rig> rig;
  std::vector<int> hidden;
  float tolerance = 0.0f;             ///< Fraction of H.
  std::vector<Pose> poses;            ///< In which the surface is looked at.
  std::vector<LevelMuscles> muscles;  ///< [poses]
};

/// @param next  as for findLevels()
[[nodiscard]] LevelSources levelSources(const Preparation& next, std::shared_ptr<const Rig> rig, float tolerance,
                                        std::vector<Pose> poses);

/// [V+E+T] carriers at which some sample may differ from what it was: those of triangles from which a ray can meet a
/// muscle that is not the same, before or after, in one of the poses. All where `former` does not serve.
/// @param former  of the same character, or null
[[nodiscard]] std::vector<bool> carriersToLookAt(const Preparation& next, const LevelSources& asked,
                                                 const LevelSources* former);

}  // namespace sinew
