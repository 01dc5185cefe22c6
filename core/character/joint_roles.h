// core/character/joint_roles.h: what a joint is in a body, as far as names and the tree tell.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/character/body_slots.h"
#include "sinew/character/skeleton.h"

namespace sinew {

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
