// core/surface/projection/anchors.h: for each refined vertex the closest point on the skeleton (paper 4.2).
#pragma once

#include <span>
#include <vector>

#include "sinew/character/pose.h"
#include "sinew/character/skeleton.h"

namespace sinew {

/// A point that rides on a bone.
struct Anchor {
  int bone = 0;
  glm::vec3 pointInBone{0.0f};
};

/// Closest points in the bind pose. The skeleton is the segments from each bone's origin to its children's origins, and
/// to its tip where it has none; the lower bone index wins a tie. A segment moves with the bone it starts at; its end,
/// a child's origin, with the child: else the many vertices closest to a joint would hang on rounding.
/// @param points [N] bind pose, world.  @return [N]
[[nodiscard]] std::vector<Anchor> findAnchors(const Skeleton& skeleton, std::span<const glm::vec3> points);

/// Anchors in a pose. @param out [N] world.
void poseAnchors(std::span<const Anchor> anchors, const Pose& pose, std::vector<glm::vec3>& out);

}  // namespace sinew
