// core/rig/reparent.h: what becomes of a muscle that moves to another bone.
#pragma once

#include "sinew/character/skeleton.h"
#include "sinew/geometry/geometry.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// The placement in `to` that looks as `inFrom` does in `from`, in one pose: the same ellipsoid in the world, whatever
/// the bones' scale and shear (affine_image.h). A flattened bone: the placement as it was.
[[nodiscard]] Placement carryToBone(const Placement& inFrom, const glm::mat4& fromInWorld, const glm::mat4& toInWorld);

/// The primitive at the same place along another bone, as much larger as that bone is longer (keyed and driven lengths
/// too), with its default territory. From a bone that is not there: as large as it was.
[[nodiscard]] Primitive scaleToBone(Primitive primitive, const Skeleton& skeleton, int bone);

}  // namespace sinew
