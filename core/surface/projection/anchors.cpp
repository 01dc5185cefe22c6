// core/surface/projection/anchors.cpp: closest point over all bone segments.
#include "core/surface/projection/anchors.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/character/bone_segments.h"
#include "core/geometry/at.h"

namespace sinew {

/// Finds for each point the closest point of the skeleton (paper 4.2), by trying all bone segments: there are few, and
/// only the preparation does it. Anchors are found in the bind pose and then ride on their bones, so that a vertex
/// keeps its anchor in every pose; the closest point of each pose would jump from bone to bone.
std::vector<Anchor> findAnchors(const Skeleton& skeleton, std::span<const glm::vec3> points) {
  const std::vector<BoneSegment> segments = boneSegments(skeleton, bindPose(skeleton));
  std::vector<Anchor> anchors;
  anchors.reserve(points.size());
  for (const glm::vec3& point : points) {
    Anchor anchor;
    float nearest = std::numeric_limits<float>::infinity();
    for (const BoneSegment& bones : segments) {
      const Segment segment = bones.segment();
      const float along = segment.closestTo(point);
      const glm::vec3 candidate = segment.from + segment.along * along;
      const glm::vec3 apart = candidate - point;
      const float squared = glm::dot(apart, apart);
      if (!(squared < nearest)) continue;
      nearest = squared;
      const int carrier = along == 1.0f ? bones.endBone : bones.bone;
      const Bone& bone = at(skeleton.bones, carrier);
      anchor = {carrier, glm::vec3(bone.inverseBindInWorld * glm::vec4(candidate, 1.0f))};
    }
    anchors.push_back(anchor);
  }
  return anchors;
}

void poseAnchors(std::span<const Anchor> anchors, const Pose& pose, std::vector<glm::vec3>& out) {
  out.resize(anchors.size());
  std::ranges::transform(anchors, out.begin(), [&pose](const Anchor& anchor) {
    return glm::vec3(at(pose.boneInWorld, anchor.bone) * glm::vec4(anchor.pointInBone, 1.0f));
  });
}

}  // namespace sinew
