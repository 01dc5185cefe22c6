// core/include/sinew/character/character_pose.h: samples a clip for bones and morph targets.
#pragma once

#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew {

/// samplePose() of pose.h with the weights of the character's morph targets. @param clip  one of the character's
[[nodiscard]] Pose samplePose(const Character& character, const AnimationClip& clip, float time);

}  // namespace sinew
