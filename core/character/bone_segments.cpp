// core/character/bone_segments.cpp: paths between bones, and segments from joints to the joints of their children.
#include "core/character/bone_segments.h"

#include <algorithm>
#include <cassert>

#include "core/geometry/at.h"

namespace sinew {

std::vector<int> bonesBetween(const Skeleton& skeleton, int from, int to) {
  const auto upFrom = [&](int bone) {
    std::vector<int> chain;
    for (; bone >= 0; bone = at(skeleton.bones, bone).parent) chain.push_back(bone);
    return chain;
  };
  std::vector<int> a = upFrom(from);
  std::vector<int> b = upFrom(to);
  // Drops common ancestors but the nearest.
  while (a.size() > 1 && b.size() > 1 && a[a.size() - 2] == b[b.size() - 2]) {
    a.pop_back();
    b.pop_back();
  }
  const bool sameTree = a.back() == b.back();
  std::vector<int> bones = sameTree ? a : std::vector{from};
  if (sameTree) {
    bones.insert(bones.end(), b.begin(), b.end());
  } else {
    bones.push_back(to);
  }
  std::ranges::sort(bones);
  bones.erase(std::unique(bones.begin(), bones.end()), bones.end());
  return bones;
}

std::vector<BoneSegment> boneSegments(const Skeleton& skeleton, const Pose& pose, const std::vector<bool>& hidden) {
  assert(pose.boneInWorld.size() == skeleton.bones.size());
  assert(hidden.empty() || hidden.size() == skeleton.bones.size());
  std::vector<BoneSegment> segments;
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    if (!hidden.empty() && hidden[i]) continue;
    const auto index = static_cast<int>(i);
    const Bone& bone = skeleton.bones[i];
    const glm::vec3 head(pose.boneInWorld[i][3]);
    const std::size_t before = segments.size();
    for (const int child : bone.children) {
      if (!hidden.empty() && hidden[static_cast<std::size_t>(child)]) continue;
      segments.push_back({index, child, head, glm::vec3(at(pose.boneInWorld, child)[3])});
    }
    if (segments.size() == before) {
      segments.push_back({index, index, head, glm::vec3(pose.boneInWorld[i] * glm::vec4(bone.tip, 1.0f))});
    }
  }
  return segments;
}

}  // namespace sinew
