// core/rig/reparent.cpp: a muscle in another bone's space.
#include "core/rig/reparent.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/geometry/flatness.h"

namespace sinew {
namespace {

/// In its own space.
float lengthOf(const Skeleton& skeleton, int bone) { return glm::length(at(skeleton.bones, bone).tip); }

void scaleLengths(std::vector<AnimatedNumber>& animated, float factor) {
  const auto scale = [&](Curve& curve) {
    for (glm::vec2& point : curve.points) point.y *= factor;
  };
  for (AnimatedNumber& number : animated) {
    if (!isLength(number.parameter)) continue;
    for (KeyTrack& track : number.keys) scale(track.curve);
    for (Driver& driver : number.drivers) {
      if (driver.mode != DriverMode::kMultiply) scale(driver.curve);
    }
  }
}

}  // namespace

Placement carryToBone(const Placement& inFrom, const glm::mat4& fromInWorld, const glm::mat4& toInWorld) {
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

Primitive scaleToBone(Primitive primitive, const Skeleton& skeleton, int bone) {
  const std::optional<int> from = skeleton.findBone(primitive.bone);
  const float before = from ? lengthOf(skeleton, *from) : 0.0f;
  const float factor = before > 0.0f ? lengthOf(skeleton, bone) / before : 1.0f;
  if (factor > 0.0f && std::isfinite(factor)) {
    primitive.placement.center *= factor;
    primitive.placement.radii *= factor;
    scaleLengths(primitive.animated, factor);
  }
  primitive.bone = skeleton.fileName(bone);
  primitive.territory.reset();
  return primitive;
}

}  // namespace sinew
