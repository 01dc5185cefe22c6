// app/document/reparent.h: what becomes of a placement when its primitive moves to another bone.
#pragma once

#include "sinew/base/geometry.h"
#include "sinew/primitives/ellipsoid.h"

namespace sinew::app {

/// The placement in `to` that looks as `inFrom` does in `from`, in one pose: the same ellipsoid in the world, whatever
/// the bones' scale and shear (affine_image.h). A flattened bone: the placement as it was.
[[nodiscard]] Placement carriedToBone(const Placement& inFrom, const glm::mat4& fromInWorld,
                                      const glm::mat4& toInWorld);

}  // namespace sinew::app
