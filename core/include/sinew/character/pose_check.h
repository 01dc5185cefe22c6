// core/include/sinew/character/pose_check.h: checks that a pose is valid for a character.
#pragma once

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"

namespace sinew {

/// A matrix for every bone, a weight for every morph target or none at all, and only finite numbers. Allocates nothing.
[[nodiscard]] bool isSoundPose(const Character& character, const Pose& pose);

/// The same with a reason. Error: its place is "pose", or the bone by name.
[[nodiscard]] Result<void> checkPose(const Character& character, const Pose& pose);

}  // namespace sinew
