// core/rig/line_edit.h: changes of muscle lines, as pure functions rig -> rig.
//
// As in rig_edit.h: a rig is taken by value; indices must be in range (asserted).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "sinew/character/skeleton.h"
#include "sinew/geometry/geometry.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

// What becomes of a muscle that moves to another bone.

/// The placement in `to` that looks as `inFrom` does in `from`, in one pose: the same ellipsoid in the world, whatever
/// the bones' scale and shear (affine_image.h). A flattened bone: the placement as it was.
[[nodiscard]] Placement carryToBone(const Placement& inFrom, const glm::mat4& fromInWorld, const glm::mat4& toInWorld);

/// The primitive at the same place along another bone, as much larger as that bone is longer (keyed and driven lengths
/// too), with its default territory. From a bone that is not there: as large as it was.
[[nodiscard]] Primitive scaleToBone(Primitive primitive, const Skeleton& skeleton, int bone);

/// Appends; the name is made unique. If `mirror` names a line of the rig, the two become each other's twins.
[[nodiscard]] Result<Rig> addLine(Rig rig, MuscleLine line);
/// The same in place. Error: the rig is as it was.
[[nodiscard]] Result<void> append(Rig& rig, MuscleLine line);
/// `change` must leave name and mirror alone (asserted).
[[nodiscard]] Result<Rig> editLine(Rig rig, int line, const std::function<void(MuscleLine&)>& change);
[[nodiscard]] Result<Rig> renameLine(Rig rig, int line, const std::string& name);
/// Puts primitives on a line, or with -1 on their bones alone. Lines that lose their last primitive go.
[[nodiscard]] Rig setLineOfSeveral(Rig rig, std::span<const int> primitives, int line);
/// Makes two different lines each other's twins; former twins are unlinked.
[[nodiscard]] Rig setLineMirror(Rig rig, int line, int twin);

/// Without those of `lines` that carry no primitive.
[[nodiscard]] Rig withoutIdleLines(Rig rig, std::unordered_set<std::string> lines);

/// Rig indices of the primitives on a line, ascending.
[[nodiscard]] std::vector<int> primitivesOn(const Rig& rig, const std::string& line);

}  // namespace sinew
