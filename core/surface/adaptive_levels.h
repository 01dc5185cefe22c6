// core/surface/adaptive_levels.h: how finely each edge and triangle has to be split. docs/design.md, Detail.
#pragma once

#include <memory>
#include <vector>

#include "core/surface/patches/split_triangle.h"
#include "core/surface/preparation.h"
#include "sinew/character/pose.h"
#include "sinew/surface/refinement.h"

namespace sinew {

// Levels raised until each triangle's split, as it will be made, follows the surface.

struct CheckedSplit {
  SplitLevels levels;
  bool fits = false;

  friend bool operator==(const CheckedSplit&, const CheckedSplit&) = default;
};

/// [T] what is known of each triangle's splits: it follows from the triangle's own surface alone.
using CheckedSplits = std::vector<std::vector<CheckedSplit>>;

/// Graded levels, at least `needed`, at which samples of all splits lie within the tolerance of their flat pieces. The
/// fit knows the n^2 split alone; where sides and inside differ, points lie elsewhere. A triangle that fails gets sides
/// as fine as its inside, else a finer inside, a few times at most.
/// @param next  as for findLevels()
/// @param tolerance  world units
/// @param known  read, and added to
[[nodiscard]] RefinementLevels levelsThatFit(const Preparation& next, const std::vector<Pose>& poses, float tolerance,
                                             RefinementLevels needed, CheckedSplits& known);

// Where an edit can have changed what adaptive detail sees. docs/design.md, Detail.

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

/// Levels, and all that they follow from: a function of character and rig, never of the pose or of what was edited.
struct AdaptiveLevels {
  RefinementLevels levels;  ///< Graded (patches/level_grading.h), and checked (split_check.h).

  // To find them again after an edit only where it has changed something.
  RefinementLevels needed;  ///< Before grading.
  CheckedSplits checked;
  LevelSources from;
  std::shared_ptr<const std::vector<Pose>> moments;  ///< Of the character.
};

/// The least levels at which flat triangles stay within the tolerance of the finely sampled surface, and interpolated
/// normals within 8 degrees of its own where it is smooth, in all detailPoses().
/// @param next  attached; its refinement, tiles, anchors and readings of the bind pose are not read
/// @param tolerance  fraction of H
/// @param former  of the same character, or null
[[nodiscard]] std::shared_ptr<const AdaptiveLevels> findLevels(const Preparation& next, std::shared_ptr<const Rig> rig,
                                                               float tolerance, const AdaptiveLevels* former);

}  // namespace sinew
