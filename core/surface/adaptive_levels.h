// core/surface/adaptive_levels.h: how finely each edge and triangle has to be split. docs/design.md, Detail.
#pragma once

#include <memory>
#include <vector>

#include "core/surface/level_changes.h"
#include "core/surface/preparation.h"
#include "core/surface/split_check.h"
#include "sinew/surface/refinement.h"

namespace sinew {

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
