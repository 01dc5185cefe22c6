// core/character/pose.cpp: local transforms -> world matrices of the bones.
#include "sinew/character/pose.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <vector>

#include "core/character/node_world.h"
#include "core/character/pose_override.h"
#include "core/geometry/at.h"
#include "sinew/character/node_locals.h"

namespace sinew {
namespace {

/// The turns of a clip that turns the bind pose; every channel is the rotation of a bone's node.
PoseOverrides turnsAt(const Skeleton& skeleton, const AnimationClip& clip, float time) {
  std::vector<int> boneOfNode(skeleton.nodes.size(), -1);
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    at(boneOfNode, skeleton.bones[i].node) = static_cast<int>(i);
  }
  PoseOverrides turns;
  for (const Channel& channel : clip.channels) {
    const glm::vec4 value = sampleChannel(channel, time);
    const int bone = at(boneOfNode, channel.node);
    if (bone >= 0) turns.set(bone, glm::quat(value.w, value.x, value.y, value.z));
  }
  return turns;
}

}  // namespace

Pose bindPose(const Skeleton& skeleton) {
  Pose pose;
  pose.boneInWorld.reserve(skeleton.bones.size());
  for (const Bone& bone : skeleton.bones) pose.boneInWorld.push_back(bone.bindInWorld);
  return pose;
}

Pose poseFromLocals(const Skeleton& skeleton, std::span<const LocalTransform> locals) {
  assert(locals.size() == skeleton.nodes.size());
  std::vector<glm::dmat4> nodes;
  nodes.reserve(locals.size());
  for (const LocalTransform& local : locals) nodes.emplace_back(local.toMatrix());
  Pose pose;
  followParents(skeleton, nodes, pose.boneInWorld);
  return pose;
}

Pose restPose(const Skeleton& skeleton) { return poseFromLocals(skeleton, restLocals(skeleton)); }

Pose samplePose(const Skeleton& skeleton, const AnimationClip& clip, float time) {
  const float clamped = std::clamp(time, 0.0f, clip.duration);
  const auto sampled = [&] {
    if (clip.turnsBindPose) return posed(skeleton, bindPose(skeleton), turnsAt(skeleton, clip, clamped));
    return poseFromLocals(skeleton, sampleLocals(skeleton, clip, clamped));
  };
  Pose pose = sampled();
  pose.clip = clip.name;
  pose.time = clamped;
  return pose;
}

}  // namespace sinew
