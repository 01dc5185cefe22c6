// core/include/sinew/character/local_pose.h: bones as an animation system has them, against their parents.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"

namespace sinew {

/// How every bone stands to its node's parent, as in glTF: T R S. An empty list: as at rest. Nodes that are no bones
/// rest.
struct BoneLocals {
  std::span<const glm::quat> rotations{};     ///< [bones] unit.
  std::span<const glm::vec3> translations{};  ///< [bones]
  std::span<const glm::vec3> scales{};        ///< [bones]
};

/// Matrices of a pose from locals; the rest of `out` stays as it is. Allocates nothing once `out` and `scratch` have
/// grown. Error: a list is of another length, a number is not finite, or a bone whose rest is a matrix in the file is
/// given some lists and not all; then `out` stays as it is.
/// @param scratch  memory that is kept from pose to pose
[[nodiscard]] Result<void> poseFromLocals(const Skeleton& skeleton, const BoneLocals& locals,
                                          std::vector<glm::dmat4>& scratch, Pose& out);
/// The same as a pose of its own.
[[nodiscard]] Result<Pose> poseFromLocals(const Skeleton& skeleton, const BoneLocals& locals);

}  // namespace sinew
