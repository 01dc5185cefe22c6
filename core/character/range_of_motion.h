// core/character/range_of_motion.h: a clip that takes every joint through what it can do.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/character/body_slots.h"
#include "sinew/character/animation_clip.h"
#include "sinew/character/skeleton.h"

namespace sinew {

inline constexpr std::string_view kRangeOfMotionName = "Range of motion";

/// What a skeleton alone does not tell. Empty: found from where bones lie and from names.
struct RangeOfMotionHints {
  std::vector<int> twinOf;                  ///< [bones] as MirrorPlan::twinOf (core/rig/mirror.h).
  glm::vec3 planeNormal{1.0f, 0.0f, 0.0f};  ///< Normal of the mirror plane, unit, bind pose; read with twinOf.
  std::vector<bool> carriesSkin;            ///< [bones] skin follows it: joints that move no skin stay out of the clip.
  std::vector<std::optional<Slot>> parts;   ///< [bones] of the body, for bones whose names say nothing.
  std::optional<glm::vec3> left;            ///< Where names call nothing left; unit, bind pose.
};

/// One way a joint turns, from its bind pose and back.
struct JointMovement {
  int bone = 0;
  glm::vec3 axis{1.0f, 0.0f, 0.0f};  ///< Unit; in the bone's turn frame (pose_override.h), bind pose.
  float from = 0.0f;                 ///< Radians, <= 0.
  float to = 0.0f;                   ///< Radians, >= 0.
};

/// Movements that happen at the same time: a left and a right joint, all fingers, a tail.
using MovementStep = std::vector<JointMovement>;

/// The script: joint after joint, parents first. The root and the hips, which move the whole body, are left out, and
/// ends. Elbows, knees, fingers bend one way; shoulders and hips swing about three axes; spine, neck and tail bend a
/// little; what names do not tell goes 45 degrees both ways about three axes. Forwards is where the character faces:
/// left x up, left from names, else +X.
[[nodiscard]] std::vector<MovementStep> rangeOfMotionSteps(const Skeleton& skeleton,
                                                           const RangeOfMotionHints& hints = {});

/// The same as a clip of that name, eased: a second for a step that goes one way, one and a half where it goes both
/// ways. Starts and ends in the bind pose, bit for bit, so that it loops. Keys on frames of 1/30 s. Without channels if
/// nothing can turn.
[[nodiscard]] AnimationClip rangeOfMotion(const Skeleton& skeleton, const RangeOfMotionHints& hints = {});

}  // namespace sinew
