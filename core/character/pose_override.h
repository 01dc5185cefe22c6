// core/character/pose_override.h: joints turned by hand, on top of a moment of the skeleton.
//
// A turn is a rotation q in the joint's own frame N: the axes of the bone's matrix made perpendicular and unit, x
// first, with the matrix's handedness kept. In the world the joint, and all that hangs on it, turns rigidly by N q N^T
// about the joint's origin. Without scale, or with an even one, that is the bone's local rotation multiplied by q from
// the right, as in any animation package; under uneven scale nothing is sheared. Turns of parents come before those of
// their children.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/pose.h"

namespace sinew {

/// One joint's turn.
struct JointTurn {
  int bone = 0;                            ///< Index into Skeleton::bones.
  glm::quat turn{1.0f, 0.0f, 0.0f, 0.0f};  ///< Unit.

  friend bool operator==(const JointTurn&, const JointTurn&) = default;
};

/// What the turns start from.
enum class TurnsFrom {
  kMoment,    ///< The sampled pose: the clip goes on under them.
  kBindPose,  ///< Turned joints stand to their parent as in the bind pose, whatever the clip says of their rotation.
};

/// A pose made by hand. View state: no part of a rig.
struct PoseOverrides {
  std::vector<JointTurn> turns;  ///< Ascending bones; none is the identity.
  TurnsFrom from = TurnsFrom::kMoment;

  [[nodiscard]] bool isEmpty() const { return turns.empty(); }
  /// The identity where a bone is not turned.
  [[nodiscard]] glm::quat turnOf(int bone) const;
  /// Normalizes; the identity (also as -1), or what cannot be normalized, takes the bone's turn away.
  void set(int bone, const glm::quat& turn);

  friend bool operator==(const PoseOverrides&, const PoseOverrides&) = default;
};

/// Columns: a joint's axes as turns see them, in the world. Perpendicular and unit also where the bone is sheared or
/// flattened.
[[nodiscard]] glm::mat3 turnFrame(const glm::mat4& boneInWorld);

/// The pose with the turns. What no turn reaches stays as it is, bit for bit. Bones beyond the skeleton are ignored.
[[nodiscard]] Pose posed(const Skeleton& skeleton, Pose pose, const PoseOverrides& overrides);

/// The turn with which TurnsFrom::kBindPose gives a bone the orientation that it has in the pose.
[[nodiscard]] glm::quat heldTurn(const Skeleton& skeleton, const Pose& pose, int bone);

/// The same joints in the same attitude at this moment, with turns that start from something else.
/// @param sampled  the moment without turns.
[[nodiscard]] PoseOverrides startingFrom(TurnsFrom from, const Skeleton& skeleton, const Pose& sampled,
                                         const PoseOverrides& overrides);

/// What a turn of one bone is on its mirror twin: the reflection, seen in the bind pose.
/// @param planeNormal  of the mirror plane, unit, world.
[[nodiscard]] glm::quat mirroredTurn(const glm::quat& turn, const Bone& bone, const Bone& twin,
                                     const glm::vec3& planeNormal);

/// Every turn on the other side: left becomes right and right left; center joints are mirrored in place.
/// @param twinOf  [bones] its counterpart, itself for center bones, -1: none; then its turn stays where it is.
[[nodiscard]] PoseOverrides mirroredPose(const PoseOverrides& overrides, const Skeleton& skeleton,
                                         std::span<const int> twinOf, const glm::vec3& planeNormal);

}  // namespace sinew
