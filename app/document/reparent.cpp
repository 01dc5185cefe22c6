// app/document/reparent.cpp: a placement in another bone's space.

#include "app/document/reparent.h"

#include <algorithm>

#include "core/base/flatness.h"
#include "core/primitives/affine_image.h"

namespace sinew::app {

Placement carriedToBone(const Placement& inFrom, const glm::mat4& fromInWorld, const glm::mat4& toInWorld) {
  if (!isFinite(fromInWorld) || !isFinite(toInWorld)) return inFrom;
  const glm::dmat4 from(fromInWorld);
  const glm::dmat4 to(toInWorld);
  if (isFlat(glm::dmat3(from)) || isFlat(glm::dmat3(to))) return inFrom;
  const glm::dmat4 toFromFrom = glm::inverse(to) * from;
  const Placement image = imageOf(inFrom, {glm::dmat3(toFromFrom), glm::dvec3(toFromFrom[3])});
  const bool usable =
      isFinite(image.center) && isFinite(image.radii) && std::min({image.radii.x, image.radii.y, image.radii.z}) > 0.0f;
  return usable ? image : inFrom;
}

}  // namespace sinew::app
