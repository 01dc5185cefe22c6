// core/include/sinew/character/pose_check.h: whether a pose is one of a character.
#pragma once

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"

namespace sinew {

/// A matrix for every bone, a weight for every morph target or none at all, and only finite numbers. Allocates nothing.
[[nodiscard]] bool isSoundPose(const Character& character, const Pose& pose);

/// The same with the reason. Error: place is "pose", or the bone by name.
[[nodiscard]] Result<void> checkPose(const Character& character, const Pose& pose);

}  // namespace sinew
