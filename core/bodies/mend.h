// core/bodies/mend.h: changes muscles until their bellies stay in the flesh. docs/muscles.md.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/bodies/check.h"
#include "core/bodies/motions.h"
#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

struct DrawnMuscle {
  BellyChoice choice;
  bool isClean = true;
};

/// Keeps a muscle just drawn across a joint in the flesh (docs/muscles.md). Takes the first candidate that is clean in
/// all poses: one that follows one bone of the line, with a tendon across the joint; the same with one end of a line
/// across several joints moved to a bone between; one that rides a bone, the best of these if none is clean. Full
/// contraction is learned from the motions. nullopt: there is no skin to follow.
/// @param drawn  on a line with a valid rest (lineRest)
[[nodiscard]] std::optional<DrawnMuscle> withDrawnMuscle(const BellyChoice& drawn, const SurfaceSettings& surface,
                                                         const Motions& motions);

/// Tries only candidates that leave the muscle's place and shape. nullopt: none is clean.
[[nodiscard]] std::optional<BellyChoice> withNearerEnd(const BellyChoice& drawn, const SurfaceSettings& surface,
                                                       const Motions& motions);

/// Origin of a line, which decides what may change.
enum class MadeLine {
  kBefore,    ///< Existed before: its muscle stays.
  kOtherEnd,  ///< New, for an existing muscle: its other end may move.
  kDrawn,     ///< New, with its muscle: both may move.
};

struct Mended {
  Rig rig;
  std::string said;      ///< "pivot 0.3, via point on thigh.L"; empty: nothing had to be changed.
  bool isClean = true;   ///< False: findings remain.
  bool isRigid = false;  ///< No line is good enough: its muscles ride bones.
};

/// Looks for a line that keeps its first belly under the skin in all poses. Tries in this order: the line as it is; a
/// pivot that fades where the bone is far; a via point at the belly's middle on the bones that carry the skin there;
/// one beside the joint. If none is clean, takes the best, or no line if that is twice as bad as a finding. Then
/// reduces flex, tendons and volume until the belly no longer swells to a ball. Twins stay as they are. A new line
/// learns its full contraction from the motions. If no candidate is clean and it carries one muscle, that muscle is
/// laid deeper or follows one of the line's bones (withDrawnMuscle); remaining findings are reported in `said`.
[[nodiscard]] Result<Mended> withMendedLine(Rig rig, int line, const Motions& motions, MadeLine made);

struct MendedRig {
  Rig rig;
  std::vector<std::string> said;  ///< One entry for each changed line: "calf L: pivot 0.3".
};

/// Mends every line with findings (check()) and its twin; not muscles without a line. @param plan  null: twins stay
[[nodiscard]] Result<MendedRig> withMendedFindings(Rig rig, std::span<const Finding> findings, const Motions& motions,
                                                   const MirrorPlan* plan);

/// check(), for the primitives from `first` on that are of no sheet.
[[nodiscard]] std::vector<Finding> findingsFrom(const Rig& rig, std::size_t first, const Motions& motions);

/// withMendedFindings(), then withMendedBelly() for bellies that still have findings; removes skin of other limbs from
/// territories. Findings may remain. @param plan  null: twins stay as they are
[[nodiscard]] Result<MendedRig> withMendedRig(Rig rig, std::size_t first, const Motions& motions,
                                              const MirrorPlan* plan);

}  // namespace sinew
