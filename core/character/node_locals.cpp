// core/character/node_locals.cpp: channels over the rest pose.
#include "sinew/character/node_locals.h"

#include "core/geometry/at.h"

namespace sinew {
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

}  // namespace sinew
