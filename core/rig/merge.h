// core/rig/merge.h: the muscles of one rig brought into another.
//
// References are followed by index, old -> new: a name in one rig says nothing of the same name in the other. Only what
// the two are to share is found by its name: groups, channels, and lines that are read but carry nothing.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

// Some muscles of a rig as a rig of their own.

/// The primitives with the lines that they ride, the lines and channels that drivers of these read, their groups and
/// the links between these. Links to twins that stay behind are left out, as are drivers of lines that are only read.
/// @param primitives  rig indices, in the order that they get
[[nodiscard]] Rig excerpt(const Rig& rig, std::span<const int> primitives);

/// What a merge has made.
struct Merged {
  /// A primitive that is left out.
  struct Refusal {
    int primitive = 0;  ///< Index into `from`.
    Error why;
  };
  /// A driver that is left out: there is no such line.
  struct LostDriver {
    std::string owner;  ///< Name of the primitive or line in the result.
    std::string line;
  };

  Rig rig;
  std::vector<int> primitives;  ///< [primitives of `from`] index in `rig`, or -1.
  std::vector<int> lines;       ///< [lines of `from`] the same; there are those that carry a primitive that is.
  std::vector<Refusal> refusals;
  std::vector<LostDriver> lostDrivers;
};

/// `into` with the primitives of `from` at the end, in their order, under free names; twins that both come are twins,
/// and the second is named after what the first has become. Their lines come with them and are not shared; groups and
/// channels that are absent are made, and absent groups linked as in `from`. Left out: what is on a bone that the
/// skeleton lacks, has no image, or finds no room. Error: the groups make too many cliques.
/// @param from    valid
/// @param mirror  null, or the plan by which all of it comes to the other side
[[nodiscard]] Result<Merged> mergeRigs(Rig into, const Rig& from, const Skeleton& skeleton, const MirrorPlan* mirror);

/// A rig whose primitives are all on one bone, or with their twins on a pair, on another bone (reparent.h): of twins
/// the one on its side of the plane, and the other as its image. Nothing: they are on several, on `bone`, or ride
/// lines.
/// @param plan  null: twins become single
[[nodiscard]] std::optional<Rig> moveToBone(const Rig& rig, const Skeleton& skeleton, int bone, const MirrorPlan* plan);

}  // namespace sinew
