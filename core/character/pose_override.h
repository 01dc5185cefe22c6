// core/character/pose_override.h: manual rotations of joints on top of a pose.
//
// A turn is a rotation q in the joint's own frame N: the axes of the bone's matrix, orthonormalized with x first,
// handedness kept. In the world the joint and everything below it rotate rigidly by N q N^T about the joint's origin.
// Without scale or with uniform scale, that multiplies the bone's local rotation by q from the right; with non-uniform
// scale nothing is sheared. Turns of parents are applied before those of their children.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/pose.h"

namespace sinew {

struct JointTurn {
  int bone = 0;                            ///< Index into Skeleton::bones.
  glm::quat turn{1.0f, 0.0f, 0.0f, 0.0f};  ///< Unit.

  friend bool operator==(const JointTurn&, const JointTurn&) = default;
};

/// The pose to which turns are added.
enum class TurnsFrom {
  kMoment,    ///< The sampled pose: the clip goes on.
  kBindPose,  ///< Turned joints ignore the clip and start from the bind pose relative to their parents.
};

/// A pose made by hand. View state, not part of a rig.
struct PoseOverrides {
  std::vector<JointTurn> turns;  ///< Ascending bones; none the identity.
  TurnsFrom from = TurnsFrom::kMoment;

  [[nodiscard]] bool isEmpty() const { return turns.empty(); }
  [[nodiscard]] glm::quat turnOf(int bone) const;  ///< The identity for a bone that is not turned.
  /// Normalizes; the identity, also as -1, or a quaternion that cannot be normalized removes the bone's turn.
  void set(int bone, const glm::quat& turn);

  friend bool operator==(const PoseOverrides&, const PoseOverrides&) = default;
};

/// The frame N of a joint, columns in the world; orthonormal also if the bone is sheared or flattened.
[[nodiscard]] glm::mat3 turnFrame(const glm::mat4& boneInWorld);

/// The pose with the turns. Bones that no turn affects stay bit for bit; turns of bones that it lacks are ignored.
[[nodiscard]] Pose posed(const Skeleton& skeleton, Pose pose, const PoseOverrides& overrides);

/// The turn with which TurnsFrom::kBindPose gives a bone its orientation in the pose.
[[nodiscard]] glm::quat heldTurn(const Skeleton& skeleton, const Pose& pose, int bone);

/// Turns that give the same joints the same orientation on top of another pose. @param sampled  the pose without turns.
[[nodiscard]] PoseOverrides startingFrom(TurnsFrom from, const Skeleton& skeleton, const Pose& sampled,
                                         const PoseOverrides& overrides);

/// The mirror image of a turn on the twin bone, in the bind pose. @param planeNormal  unit, world.
[[nodiscard]] glm::quat mirroredTurn(const glm::quat& turn, const Bone& bone, const Bone& twin,
                                     const glm::vec3& planeNormal);

/// Swaps left and right turns and mirrors those of center joints in place.
/// @param twinOf  [bones] counterpart, itself for center bones; -1: none, then its turn stays.
[[nodiscard]] PoseOverrides mirroredPose(const PoseOverrides& overrides, const Skeleton& skeleton,
                                         std::span<const int> twinOf, const glm::vec3& planeNormal);

}  // namespace sinew
