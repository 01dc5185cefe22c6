// core/character/range_of_motion.h: makes a clip that moves every joint through its range.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/character/body_slots.h"
#include "sinew/character/animation_clip.h"
#include "sinew/character/skeleton.h"

namespace sinew {

inline constexpr std::string_view kRangeOfMotionName = "Range of motion";

/// Arguments of rangeOfMotion() besides the skeleton. Empty: found from names and places of bones.
struct RangeOfMotionHints {
  std::vector<int> twinOf;                  ///< [bones] as MirrorPlan::twinOf (core/rig/mirror.h).
  glm::vec3 planeNormal{1.0f, 0.0f, 0.0f};  ///< Normal of the mirror plane, unit, bind pose; read with twinOf.
  std::vector<bool> carriesSkin;            ///< [bones] skin follows the bone; joints that move no skin are left out.
  std::vector<std::optional<Slot>> parts;   ///< [bones] body parts, for bones with unknown names.
  std::optional<glm::vec3> left;            ///< For characters whose names have no sides; unit, bind pose.
};

/// A rotation of a joint from its bind pose and back.
struct JointMovement {
  int bone = 0;
  glm::vec3 axis{1.0f, 0.0f, 0.0f};  ///< Unit; in the bone's turn frame (pose_override.h), bind pose.
  float from = 0.0f;                 ///< Radians, <= 0.
  float to = 0.0f;                   ///< Radians, >= 0.
};

/// Simultaneous movements: of a left and a right joint, all fingers, a tail.
using MovementStep = std::vector<JointMovement>;

/// The movements, joint by joint, parents first, without root, hips and ends. Elbows, knees and fingers bend one way;
/// shoulders and hip joints swing about three axes; spine, neck and tail bend a little; unknown joints turn 45 degrees
/// both ways about three axes. Forward is left x up, with left from names, else +X.
[[nodiscard]] std::vector<MovementStep> rangeOfMotionSteps(const Skeleton& skeleton,
                                                           const RangeOfMotionHints& hints = {});

/// The movements as an eased clip kRangeOfMotionName: 1 s for a step that goes one way, 1.5 s for one that goes both
/// ways, with keys every 1/30 s. Starts and ends exactly in the bind pose, so that it loops. No channels if no joint
/// can turn.
[[nodiscard]] AnimationClip rangeOfMotion(const Skeleton& skeleton, const RangeOfMotionHints& hints = {});

}  // namespace sinew
