// core/bodies/mend.h: muscle lines changed until their bellies stay in the flesh. docs/muscles.md.
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

// A muscle that has just been drawn over a joint, kept in the flesh.

struct DrawnMuscle {
  BellyChoice choice;
  bool isClean = true;
};

/// The first that stays in the flesh in all poses (docs/muscles.md): muscles that go with one bone of the line, while a
/// tendon crosses the joint; the same with an end of a line over several joints on a bone between; one that rides a
/// bone, the best of these if none is clean. Full contraction is learned from the motions. nullopt: there is no skin to
/// follow.
/// @param drawn  on a line that has a rest
[[nodiscard]] std::optional<DrawnMuscle> withDrawnMuscle(const BellyChoice& drawn, const SurfaceSettings& surface,
                                                         const Motions& motions);

/// Of these only those that leave the muscle where it is and as it is. nullopt: none is clean.
[[nodiscard]] std::optional<BellyChoice> withNearerEnd(const BellyChoice& drawn, const SurfaceSettings& surface,
                                                       const Motions& motions);

/// Where a line comes from, which says what may be changed of it.
enum class MadeLine {
  kBefore,    ///< It was there: its muscle stays.
  kOtherEnd,  ///< Just made for a muscle that was there: its other end may move.
  kDrawn,     ///< Just made with its muscle: both may be laid elsewhere.
};

struct Mended {
  Rig rig;
  std::string said;      ///< "pivot 0.3, via point on thigh.L"; empty: nothing had to be changed.
  bool isClean = true;   ///< False: something is still found.
  bool isRigid = false;  ///< No line would do: its muscles ride their bones.
};

/// Tries, in this order, what keeps the line's first belly under the skin over all poses: the line as it is; a pivot
/// that fades where the bone is far; a via point at the belly's middle on the bones that carry the skin there; one
/// beside the joint. If none does, the best of them; none if that is twice as bad as what is found. Then tendons,
/// flex, volume and limits are taken back until the belly swells to a ball no more. Twins stay as they are
/// (core/rig/twins.h).
/// A line that has just been made learns its full contraction from the motions. Where no candidate is clean and it
/// carries one muscle, that lies deeper or goes with one of the line's bones (mend_drawn.h), and what is still found is
/// said.
[[nodiscard]] Result<Mended> withMendedLine(Rig rig, int line, const Motions& motions, MadeLine made);

struct MendedRig {
  Rig rig;
  std::vector<std::string> said;  ///< Of each line that was changed: "calf L: pivot 0.3".
};

/// Mends every line that something was found of, and its twin with it. What muscles on one bone do is their designer's
/// to change.
/// @param findings  check() of this rig  @param plan  null: twins stay as they are
[[nodiscard]] Result<MendedRig> withMendedFindings(Rig rig, std::span<const Finding> findings, const Motions& motions,
                                                   const MirrorPlan* plan);

// All that is found of a rig's muscles, mended. docs/muscles.md.

/// check(), of the primitives from `first` on.
[[nodiscard]] std::vector<Finding> findingsFrom(const Rig& rig, std::size_t first, const Motions& motions);

/// Lines first (withMendedFindings); of what is still found, what a muscle rides and how deep it lies
/// (withMendedBelly); skin of another limb goes from territories. Something may be left.
/// @param plan  null: twins stay as they are
[[nodiscard]] Result<MendedRig> withMendedRig(Rig rig, std::size_t first, const Motions& motions,
                                              const MirrorPlan* plan);

}  // namespace sinew
