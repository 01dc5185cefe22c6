// core/character/joint_roles.h: what a joint is in a body, as far as names and the tree tell.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/character/body_slots.h"
#include "core/character/bone_names.h"
#include "sinew/character/skeleton.h"

namespace sinew {

// The limbs of one side, as chains of bones from the trunk outwards.

/// A skeleton with all that the search for parts reads. Bind pose, world.
struct SlotSearch {
  const Skeleton& skeleton;
  std::vector<BoneName> names;    ///< [bones]
  std::vector<bool> active;       ///< [bones] moves skin.
  std::vector<int> twinOf;        ///< [bones] itself: center; -1: none.
  std::vector<glm::vec3> joints;  ///< [bones]
  glm::vec3 left{1.0f, 0.0f, 0.0f};
  float middle = 0.0f;  ///< Of the mirror plane, along `left`.
  float ground = 0.0f;  ///< y of the lowest joint.
  float height = 1.0f;

  [[nodiscard]] int parentOf(int bone) const;
  /// +1: on the left, -1: on the right, 0: neither.
  [[nodiscard]] int sideOf(int bone) const;
  [[nodiscard]] bool isAbove(int above, int bone) const;  ///< In the tree; a bone is above itself.
  [[nodiscard]] int commonAncestor(int a, int b) const;   ///< -1: none.
};

[[nodiscard]] SlotSearch makeSearch(const Skeleton& skeleton, const SlotHints& hints);

/// One limb: from the first bone on its side to the last.
struct LimbChain {
  std::vector<int> bones;       ///< Not empty.
  std::vector<glm::vec3> ends;  ///< [bones] where each one's segment ends.
  int attach = -1;              ///< The bone that carries it, or -1.
  float length = 0.0f;
  float lowest = 0.0f;  ///< y, over its joints and its tip.
  LimbWord word = LimbWord::kNone;

  [[nodiscard]] glm::vec3 segment(std::size_t i, const SlotSearch& search) const;
};

/// Those on the left that are long enough or named.
[[nodiscard]] std::vector<LimbChain> leftLimbs(const SlotSearch& search);

// Bones that move no skin: targets, poles, sockets, ends.

/// [bones] Skin follows the bone or one below it. @param carriesSkin  [bones] skin follows it; empty: all do.
[[nodiscard]] std::vector<bool> bonesThatMoveSkin(const Skeleton& skeleton, const std::vector<bool>& carriesSkin);

/// [bones] The others: what a designer of muscles need not see. None where no bone moves skin.
[[nodiscard]] std::vector<bool> helperBones(const Skeleton& skeleton, const std::vector<bool>& carriesSkin);

enum class JointRole {
  kStill,  ///< Moves the whole body (root, hips) or nothing that is seen (targets, sockets, ends).
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
  kFree,   ///< Nothing is known of it.
};

/// [bones]. Words in names of any style ("mixamorig:LeftForeArm", "forearm.L", "b_LeftForeArm_010", "左ひじ") and where
/// in a limb a bone stands: the first of an arm is its shoulder, whatever it is called, the next its elbow.
/// @param parts  [bones] the parts of the body. Where names say nothing of most of them, they count for bones whose
/// names say nothing; empty: names alone
[[nodiscard]] std::vector<JointRole> jointRoles(const Skeleton& skeleton,
                                                std::span<const std::optional<Slot>> parts = {});

}  // namespace sinew
