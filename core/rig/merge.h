// core/rig/merge.h: merges muscles of one rig into another.
//
// References are followed by index, since equal names in two rigs do not mean the same thing. Only shared things are
// matched by name: groups, channels, and lines that drivers read but that carry no muscle.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// A rig of some primitives with their lines, their groups and the links between these, and the lines and channels that
/// drivers of all these read. Without links to other twins, and without drivers of lines that are only read.
/// @param primitives  rig indices, in the order of the result
[[nodiscard]] Rig excerpt(const Rig& rig, std::span<const int> primitives);

struct Merged {
  /// A primitive that was left out.
  struct Refusal {
    int primitive = 0;  ///< Index into `from`.
    Error why;
  };
  /// A driver that was left out because its line does not exist.
  struct LostDriver {
    std::string owner;  ///< Name of the primitive or line in the result; of a link "legs and torso".
    std::string line;
  };

  /// A sheet that was left out.
  struct SheetRefusal {
    std::string sheet;
    Error why;
  };

  Rig rig;
  std::vector<int> primitives;      ///< [primitives of `from`] index in `rig`, or -1, also for bellies of sheets.
  std::vector<std::string> sheets;  ///< Names in `rig` of the sheets that were added; not yet laid.
  std::vector<int> lines;           ///< [lines of `from`] index in `rig`, or -1: carries no merged primitive.
  std::vector<Refusal> refusals;
  std::vector<SheetRefusal> sheetRefusals;
  std::vector<LostDriver> lostDrivers;
};

/// Appends the primitives of `from` under free names, with their lines. Twins stay twins, and the second is named after
/// the first. Missing groups and channels are added, and missing groups linked as in `from`. Primitives are left out if
/// their bone is missing, they have no mirror image, or the rig is full. Error: the groups make too many cliques.
/// @param from  valid  @param mirror  not null: merges the mirror images
[[nodiscard]] Result<Merged> mergeRigs(Rig into, const Rig& from, const Skeleton& skeleton, const MirrorPlan* mirror);

/// Moves all primitives from one bone to another (scaleToBone). Of a pair of twins it moves the one on the side of the
/// new bone and mirrors it. Nothing: they are on several bones, already on `bone`, on lines, or of sheets.
/// @param plan  null: twins become single
[[nodiscard]] std::optional<Rig> moveToBone(const Rig& rig, const Skeleton& skeleton, int bone, const MirrorPlan* plan);

}  // namespace sinew
