// core/character/bone_segments.h: bones as straight lines.
#pragma once

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

#include "sinew/character/pose.h"
#include "sinew/character/skeleton.h"

namespace sinew {

/// Both bones and those between them in the tree, ascending; only the two if they have no common ancestor.
[[nodiscard]] std::vector<int> bonesBetween(const Skeleton& skeleton, int from, int to);

/// A line segment, possibly of length 0.
struct Segment {
  glm::vec3 from{0.0f};
  glm::vec3 along{0.0f};  ///< From start to end.

  /// Parameter of a point's projection onto the infinite line: 0 at the start, 1 at the end.
  [[nodiscard]] float parameter(const glm::vec3& point) const {
    const float squared = glm::dot(along, along);
    return squared > 0.0f ? glm::dot(point - from, along) / squared : 0.0f;
  }
  /// Parameter of the closest point of the segment, 0..1.
  [[nodiscard]] float closestTo(const glm::vec3& point) const { return std::clamp(parameter(point), 0.0f, 1.0f); }
  [[nodiscard]] glm::vec3 nearest(const glm::vec3& point) const { return from + along * closestTo(point); }
  [[nodiscard]] float distance(const glm::vec3& point) const { return glm::distance(point, nearest(point)); }
};

/// From a bone's joint to its tip in the bind pose, world.
[[nodiscard]] inline Segment bindSegment(const Bone& bone) {
  const glm::vec3 from(bone.bindInWorld[3]);
  return {from, glm::vec3(bone.bindInWorld * glm::vec4(bone.tip, 1.0f)) - from};
}

/// Half way from a point to the bone's axis in the bind pose, world; for anchors under the skin.
[[nodiscard]] inline glm::vec3 halfWayToAxis(const Bone& bone, const glm::vec3& point) {
  return 0.5f * (point + bindSegment(bone).nearest(point));
}

/// A bone as drawn: from its joint to a child's joint, or to its own tip if no child is drawn. World.
struct BoneSegment {
  int bone = -1;
  int endBone = -1;  ///< The child at its end, or the bone itself.
  glm::vec3 head{0.0f};
  glm::vec3 tail{0.0f};

  [[nodiscard]] Segment segment() const { return {head, tail - head}; }
};

/// One for every child of every bone, in the order of the bones. @param hidden  [bones] left out; empty: none
[[nodiscard]] std::vector<BoneSegment> boneSegments(const Skeleton& skeleton, const Pose& pose,
                                                    const std::vector<bool>& hidden = {});

}  // namespace sinew
