// core/character/joint_roles.h: limbs of a skeleton and the roles of its joints, by names and the tree.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/character/body_slots.h"
#include "core/character/bone_names.h"
#include "sinew/character/skeleton.h"

namespace sinew {

/// Input of the search for body parts. Bind pose, world.
struct SlotSearch {
  const Skeleton& skeleton;
  std::vector<BoneName> names;    ///< [bones]
  std::vector<bool> active;       ///< [bones] moves skin.
  std::vector<int> twinOf;        ///< [bones] itself: center; -1: none.
  std::vector<glm::vec3> joints;  ///< [bones]
  glm::vec3 left{1.0f, 0.0f, 0.0f};
  float middle = 0.0f;  ///< Position of the mirror plane along `left`.
  float ground = 0.0f;  ///< y of the lowest joint.
  float height = 1.0f;

  [[nodiscard]] int parentOf(int bone) const;
  [[nodiscard]] int sideOf(int bone) const;               ///< +1: left, -1: right, 0: neither.
  [[nodiscard]] bool isAbove(int above, int bone) const;  ///< In the tree; true for the bone itself.
  [[nodiscard]] int commonAncestor(int a, int b) const;   ///< -1: none.
};

[[nodiscard]] SlotSearch makeSearch(const Skeleton& skeleton, const SlotHints& hints);

/// The bones of one limb, from the trunk outwards.
struct LimbChain {
  std::vector<int> bones;       ///< Not empty.
  std::vector<glm::vec3> ends;  ///< [bones] ends of their segments.
  int attach = -1;              ///< Parent of the first bone, or -1.
  float length = 0.0f;
  float lowest = 0.0f;  ///< Smallest y of its joints and its tip.
  LimbWord word = LimbWord::kNone;

  [[nodiscard]] glm::vec3 segment(std::size_t i, const SlotSearch& search) const;
};

/// Limbs of the left side that are long enough or named.
[[nodiscard]] std::vector<LimbChain> leftLimbs(const SlotSearch& search);

/// [bones] Skin follows the bone or one below it. @param carriesSkin  [bones] skin follows the bone; empty: all.
[[nodiscard]] std::vector<bool> bonesThatMoveSkin(const Skeleton& skeleton, const std::vector<bool>& carriesSkin);

/// [bones] The others, such as targets, poles, sockets and ends, which need not be shown; none if no bone moves skin.
[[nodiscard]] std::vector<bool> helperBones(const Skeleton& skeleton, const std::vector<bool>& carriesSkin);

enum class JointRole {
  kStill,  ///< Moves the whole body (root, hips) or nothing visible (targets, sockets, ends).
  kTrunk,  ///< Spine, chest, waist.
  kNeck,   ///< Neck and head.
  kTail,
  kCollar,  ///< Between the trunk and a shoulder.
  kShoulder,
  kElbow,
  kWrist,
  kHip,  ///< Root of a leg.
  kKnee,
  kAnkle,
  kDigit,  ///< Finger or toe.
  kFree,   ///< Unknown.
};

/// [bones] Roles by words in names of any style ("mixamorig:LeftForeArm", "forearm.L", "b_LeftForeArm_010", "左ひじ")
/// and by the place in a limb: the first joint of an arm is its shoulder, whatever its name, the next its elbow.
/// @param parts  [bones] body parts, used for bones with unknown names if those are the majority; empty: names alone
[[nodiscard]] std::vector<JointRole> jointRoles(const Skeleton& skeleton,
                                                std::span<const std::optional<Slot>> parts = {});

}  // namespace sinew
