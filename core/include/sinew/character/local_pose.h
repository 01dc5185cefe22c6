// core/include/sinew/character/local_pose.h: poses from local transforms of bones, as in animation systems.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"

namespace sinew {

/// Transforms of bones relative to the parents of their nodes, as in glTF: T R S. Empty list: as at rest. Other nodes
/// are at rest.
struct BoneLocals {
  std::span<const glm::quat> rotations{};     ///< [bones] unit.
  std::span<const glm::vec3> translations{};  ///< [bones]
  std::span<const glm::vec3> scales{};        ///< [bones]
};

/// Fills the matrices of a pose; other members of `out` stay. Allocates nothing once `out` and `scratch` have grown.
/// Error: a list has the wrong length, a number is not finite, or some but not all lists are given although the rest of
/// a bone is a matrix in the file; then `out` is not changed.
/// @param scratch  memory that is reused from pose to pose
[[nodiscard]] Result<void> poseFromLocals(const Skeleton& skeleton, const BoneLocals& locals,
                                          std::vector<glm::dmat4>& scratch, Pose& out);
[[nodiscard]] Result<Pose> poseFromLocals(const Skeleton& skeleton, const BoneLocals& locals);

}  // namespace sinew
