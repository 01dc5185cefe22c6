// core/include/sinew/character/character_pose.h: a clip at a time, for bones and morph targets alike.
#pragma once

#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew {

/// samplePose of skeleton/pose.h with the weights of the character's morph targets; without any, the same.
/// @param clip  one of the character's
[[nodiscard]] Pose samplePose(const Character& character, const AnimationClip& clip, float time);

}  // namespace sinew
