// core/character/pose.cpp: local transforms -> world matrices of the bones.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <vector>

#include "core/character/pose_override.h"
#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "sinew/character/character_pose.h"
#include "sinew/character/local_pose.h"
#include "sinew/character/node_locals.h"
#include "sinew/character/pose.h"
#include "sinew/character/pose_check.h"
#include "sinew/character/skeleton.h"

namespace sinew {
namespace {

/// In double: a bone of meters may be below a node scaled by 0.01. @param boneInWorld  [bones] its memory is reused
/// @param nodes  [nodes] in: relative to the parent; out: in the world
void followParents(const Skeleton& skeleton, std::span<glm::dmat4> nodes, std::vector<glm::mat4>& boneInWorld) {
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const int parent = skeleton.nodes[n].parent;
    if (parent >= 0) nodes[n] = at(nodes, parent) * nodes[n];
  }
  boneInWorld.resize(skeleton.bones.size());
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    boneInWorld[b] = glm::mat4(at(nodes, skeleton.bones[b].node));
  }
}

/// The turns of a clip that rotates the bind pose; every channel is the rotation of a bone's node.
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

// Channels over the rest pose.

namespace {

void applyChannel(const Channel& channel, float time, LocalTransform& local) {
  const glm::vec4 value = sampleChannel(channel, time);
  switch (channel.path) {
    case ChannelPath::kTranslation:
      local.translation = glm::vec3(value);
      break;
    case ChannelPath::kRotation:
      local.rotation = glm::quat(value.w, value.x, value.y, value.z);
      break;
    case ChannelPath::kScale:
      local.scale = glm::vec3(value);
      break;
  }
}

}  // namespace

std::vector<LocalTransform> restLocals(const Skeleton& skeleton) {
  std::vector<LocalTransform> locals;
  locals.reserve(skeleton.nodes.size());
  for (const Node& node : skeleton.nodes) locals.push_back(node.rest);
  return locals;
}

std::vector<LocalTransform> sampleLocals(const Skeleton& skeleton, const AnimationClip& clip, float time) {
  std::vector<LocalTransform> locals = restLocals(skeleton);
  for (const Channel& channel : clip.channels) applyChannel(channel, time, at(locals, channel.node));
  return locals;
}

// Local transforms -> world matrices, parents first.

namespace {

bool isFiniteTurn(const glm::quat& q) {
  return std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

template <class T, class IsFinite>
Result<void> checkLocals(const char* name, std::span<const T> list, std::size_t bones, IsFinite isFiniteItem) {
  if (list.empty()) return {};
  if (list.size() != bones) {
    return errorAt(name, "expected one for each of " + std::to_string(bones) + " bones or none, got " +
                             std::to_string(list.size()));
  }
  const auto odd = std::ranges::find_if_not(list, isFiniteItem);
  if (odd == list.end()) return {};
  return errorAt(std::string(name) + "[" + std::to_string(odd - list.begin()) + "]", "expected finite numbers");
}

Result<void> checkLocals(const Skeleton& skeleton, const BoneLocals& locals) {
  const auto isFinitePoint = [](const glm::vec3& v) { return isFinite(v); };
  const std::size_t bones = skeleton.bones.size();
  if (auto fits = checkLocals("rotations", locals.rotations, bones, isFiniteTurn); !fits) return fits;
  if (auto fits = checkLocals("translations", locals.translations, bones, isFinitePoint); !fits) return fits;
  if (auto fits = checkLocals("scales", locals.scales, bones, isFinitePoint); !fits) return fits;
  const bool none = locals.rotations.empty() && locals.translations.empty() && locals.scales.empty();
  const bool all = !locals.rotations.empty() && !locals.translations.empty() && !locals.scales.empty();
  if (none || all) return {};
  for (const Bone& bone : skeleton.bones) {
    if (at(skeleton.nodes, bone.node).rest.matrix) {
      return errorAt("bone \"" + bone.name + '"',
                     "it rests by a matrix: give rotations, translations and scales, or none of them");
    }
  }
  return {};
}

}  // namespace

Result<void> poseFromLocals(const Skeleton& skeleton, const BoneLocals& locals, std::vector<glm::dmat4>& scratch,
                            Pose& out) {
  if (Result<void> sound = checkLocals(skeleton, locals); !sound) return sound;
  scratch.resize(skeleton.nodes.size());
  for (std::size_t n = 0; n < skeleton.nodes.size(); ++n) scratch[n] = glm::dmat4(skeleton.nodes[n].rest.toMatrix());
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const int node = skeleton.bones[b].node;
    LocalTransform local = at(skeleton.nodes, node).rest;
    if (!locals.rotations.empty()) local.rotation = locals.rotations[b];
    if (!locals.translations.empty()) local.translation = locals.translations[b];
    if (!locals.scales.empty()) local.scale = locals.scales[b];
    if (!locals.rotations.empty()) local.matrix.reset();  // All three are there, where it had one.
    at(scratch, node) = glm::dmat4(local.toMatrix());
  }
  followParents(skeleton, scratch, out.boneInWorld);
  return {};
}

Result<Pose> poseFromLocals(const Skeleton& skeleton, const BoneLocals& locals) {
  std::vector<glm::dmat4> scratch;
  Pose pose;
  if (Result<void> made = poseFromLocals(skeleton, locals, scratch, pose); !made) return made.error();
  return pose;
}

// Counts and finite numbers of a pose.

namespace {

bool hasAllBones(const Character& character, const Pose& pose) {
  return pose.boneInWorld.size() >= character.skeleton.bones.size();
}

bool hasAllMorphs(const Character& character, const Pose& pose) {
  return pose.morphWeights.empty() || pose.morphWeights.size() == character.morphTargets.size();
}

bool isFiniteMatrix(const glm::mat4& matrix) { return isFinite(matrix); }
bool isFiniteNumber(float number) { return std::isfinite(number); }

}  // namespace

bool isSoundPose(const Character& character, const Pose& pose) {
  return hasAllBones(character, pose) && hasAllMorphs(character, pose) &&
         std::ranges::all_of(pose.boneInWorld, isFiniteMatrix) &&
         std::ranges::all_of(pose.morphWeights, isFiniteNumber) && std::isfinite(pose.flex) && std::isfinite(pose.time);
}

Result<void> checkPose(const Character& character, const Pose& pose) {
  const auto& bones = character.skeleton.bones;
  if (!hasAllBones(character, pose)) {
    return errorAt("pose", "expected matrices of " + std::to_string(bones.size()) + " bones, got " +
                               std::to_string(pose.boneInWorld.size()));
  }
  const auto odd = std::ranges::find_if_not(pose.boneInWorld, isFiniteMatrix);
  if (odd != pose.boneInWorld.end()) {
    const auto index = static_cast<std::size_t>(odd - pose.boneInWorld.begin());
    const std::string name = index < bones.size() ? " \"" + bones[index].name + '"' : std::string();
    return errorAt("bone " + std::to_string(index) + name, "its matrix has a number that is not finite");
  }
  if (!hasAllMorphs(character, pose)) {
    return errorAt("pose", "expected weights of " + std::to_string(character.morphTargets.size()) +
                               " morph targets or none, got " + std::to_string(pose.morphWeights.size()));
  }
  if (!std::ranges::all_of(pose.morphWeights, isFiniteNumber)) {
    return errorAt("pose", "a morph target's weight is not finite");
  }
  if (!std::isfinite(pose.flex)) return errorAt("pose", "the flex is not finite");
  if (!std::isfinite(pose.time)) return errorAt("pose", "the time is not finite");
  return {};
}

// The clip's weights over the file's.

Pose samplePose(const Character& character, const AnimationClip& clip, float time) {
  Pose pose = samplePose(character.skeleton, clip, time);
  if (character.morphTargets.empty()) return pose;
  pose.morphWeights = morphWeightsOr(character, {});
  for (const MorphChannel& channel : clip.morphChannels) {
    const std::span<float> weights(pose.morphWeights);
    sampleMorphs(channel, std::clamp(time, 0.0f, clip.duration),
                 weights.subspan(toIndex(channel.firstTarget), toIndex(channel.targets)));
  }
  return pose;
}

}  // namespace sinew
