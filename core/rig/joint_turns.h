// core/rig/joint_turns.h: how far a joint is bent, twisted and turned in a pose. docs/drivers.md.
#pragma once

#include "sinew/character/pose.h"

namespace sinew {

/// Degrees between the directions of a bone and its parent, less that of the bind pose; of a root: from its direction
/// in the bind pose. Continuous in the pose. 0 where a bone is flattened.
[[nodiscard]] float bendOf(const Skeleton& skeleton, const Pose& pose, int bone);

/// The direction of a bone in its turn frame (skeleton/pose_override.h), unit.
[[nodiscard]] glm::vec3 boneDirection(const Bone& bone);

/// Degrees of a turn about an axis, the rest of the turn left out (swing and twist), -180..180. Continuous but for half
/// turns.
/// @param axis  unit
[[nodiscard]] float turnAbout(const glm::quat& turn, const glm::vec3& axis);

/// exp(-angle^2 / (2 width^2)) of the rotation between two turns: 1 where they agree. @param width  degrees
[[nodiscard]] float nearness(const glm::quat& turn, const glm::quat& wanted, float width);

}  // namespace sinew
