// core/smoothing/projection/anchors.cpp: closest point over all bone segments.
#include "core/smoothing/projection/anchors.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/base/at.h"

namespace sinew {
namespace {

struct Segment {
  int bone = 0;
  int endBone = 0;  ///< The child whose origin ends it, or the bone itself.
  glm::vec3 from{0.0f};
  glm::vec3 along{0.0f};

  /// 0 at the start, 1 at the end.
  [[nodiscard]] float closestTo(const glm::vec3& point) const {
    const float squared = glm::dot(along, along);
    return squared > 0.0f ? std::clamp(glm::dot(point - from, along) / squared, 0.0f, 1.0f) : 0.0f;
  }
};

std::vector<Segment> segmentsOf(const Skeleton& skeleton) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    const Bone& bone = skeleton.bones[i];
    const glm::vec3 origin(bone.bindInWorld[3]);
    for (const int child : bone.children) {
      const glm::vec3 end(at(skeleton.bones, child).bindInWorld[3]);
      segments.push_back({static_cast<int>(i), child, origin, end - origin});
    }
    if (bone.children.empty()) {
      const glm::vec3 end(bone.bindInWorld * glm::vec4(bone.tip, 1.0f));
      segments.push_back({static_cast<int>(i), static_cast<int>(i), origin, end - origin});
    }
  }
  return segments;
}

}  // namespace

std::vector<Anchor> findAnchors(const Skeleton& skeleton, std::span<const glm::vec3> points) {
  const std::vector<Segment> segments = segmentsOf(skeleton);
  std::vector<Anchor> anchors;
  anchors.reserve(points.size());
  for (const glm::vec3& point : points) {
    Anchor anchor;
    float nearest = std::numeric_limits<float>::infinity();
    for (const Segment& segment : segments) {
      const float along = segment.closestTo(point);
      const glm::vec3 candidate = segment.from + segment.along * along;
      const glm::vec3 apart = candidate - point;
      const float squared = glm::dot(apart, apart);
      if (!(squared < nearest)) continue;
      nearest = squared;
      const int carrier = along == 1.0f ? segment.endBone : segment.bone;
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
