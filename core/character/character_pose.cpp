// core/character/character_pose.cpp: the clip's weights over the file's.
#include "sinew/character/character_pose.h"

#include <algorithm>

#include "core/character/morphing.h"
#include "core/geometry/at.h"

namespace sinew {

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
