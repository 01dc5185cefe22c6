// core/surface/adaptive_levels.h: the levels of adaptive detail for edges and triangles. docs/design.md, Detail.
#pragma once

#include <memory>
#include <vector>

#include "core/surface/patches/split_triangle.h"
#include "core/surface/patches/triangulation.h"
#include "core/surface/preparation.h"
#include "core/surface/triangle_samples.h"
#include "sinew/character/pose.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Triangles from which on fewer samples of each do.
inline constexpr std::size_t kDenseMesh = 8'000;

struct CheckedSplit {
  SplitLevels levels;
  bool fits = false;

  friend bool operator==(const CheckedSplit&, const CheckedSplit&) = default;
};

/// [T] results for the splits of each triangle, which depend only on the triangle's own surface.
using CheckedSplits = std::vector<std::vector<CheckedSplit>>;

/// Graded levels, at least `needed`, at which samples of all splits lie within the tolerance of their flat pieces. The
/// fit covers only n^2 splits; if sides and inside differ, points lie elsewhere. A triangle that fails gets sides as
/// fine as its inside, or else a finer inside, a few times at most.
/// @param next  as for findLevels().  @param tolerance  world units.  @param known  read and extended.
[[nodiscard]] RefinementLevels levelsThatFit(const Preparation& next, SampledSurface& surface, float tolerance,
                                             RefinementLevels needed, CheckedSplits& known);

struct LevelMuscles {
  std::vector<PosedPrimitive> primitives;  ///< [A] world; hidden ones included.
  float skinBlend = 0.0f;
  float grooves = 0.0f;
  std::vector<float> links;  ///< [Rig::links] amounts.
};

/// The input of levels, besides the character.
struct LevelSources {
  std::shared_ptr<const Rig> rig;
  std::vector<int> hidden;
  float tolerance = 0.0f;             ///< Fraction of H.
  std::vector<Pose> poses;            ///< To sample the surface in.
  std::vector<LevelMuscles> muscles;  ///< [poses]
};

/// @param next  as for findLevels()
[[nodiscard]] LevelSources levelSources(const Preparation& next, std::shared_ptr<const Rig> rig, float tolerance,
                                        std::vector<Pose> poses);

/// [V+E+T] carriers at which samples may have changed: those at triangles from which a ray can meet a changed muscle,
/// before or after, in one of the poses. All if `former` is of no use.
/// @param former  of the same character, or null
[[nodiscard]] std::vector<bool> carriersToLookAt(const Preparation& next, const LevelSources& asked,
                                                 const LevelSources* former);

/// Levels and their sources: a function of character and rig, not of the pose or of former edits.
struct AdaptiveLevels {
  RefinementLevels levels;  ///< Graded (patches/levels.h) and checked.
  AlignedSplits splits;     ///< alignSplits() at these levels.

  // To search again, after an edit, only where it has changed something.
  std::vector<SplitLevels> needed;  ///< [T] before grading, of each triangle's own samples.
  std::vector<PoseSet> posesOf;     ///< [T] the poses that were sampled finely.
  CheckedSplits checked;
  LevelSources from;
  std::shared_ptr<const std::vector<Pose>> moments;  ///< Of the character.
};

/// The least levels at which, in all detailPoses(), flat triangles stay within the tolerance of the finely sampled
/// surface, and interpolated normals within 8 degrees of its own where it is smooth. These 8 degrees grow by the root
/// of the ratio above the default tolerance, and on pieces too short to be seen well.
/// @param next  attached; its refinement, tiles, anchors and bind readings are not read
/// @param tolerance  fraction of H.  @param former  of the same character, or null
[[nodiscard]] std::shared_ptr<const AdaptiveLevels> findLevels(const Preparation& next, std::shared_ptr<const Rig> rig,
                                                               float tolerance, const AdaptiveLevels* former);

}  // namespace sinew
