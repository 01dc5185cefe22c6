// core/bodies/retargeter.h: transfers a clip of another skeleton to a character's bones.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "core/character/body_slots.h"
#include "sinew/character/animation_clip.h"
#include "sinew/character/skeleton.h"

namespace sinew {

struct ClipBodies {
  const Skeleton& from;  ///< Has the clips.
  const Skeleton& to;    ///< Plays them.
  const BodySlots& fromSlots;
  const BodySlots& toSlots;
  const std::vector<int>& partner;  ///< [bones of to] bone of from, or -1
};

/// Takes the other body's bind pose into the stance of the character's.
struct CommonStance {
  /// World of the clips -> world of the character: quarter turns about y, so that both face the same way.
  glm::dquat facing{1.0, 0.0, 0.0, 0.0};
  /// [bones of to] Rotates the partner from its bind pose to that of the bone. World of the character. Arms and legs
  /// get the smallest rotation, from the trunk outwards; hands follow the arms; trunk, head and feet are not rotated.
  std::vector<glm::dquat> turn;
  int hips = -1;             ///< Bone of the character whose translation is transferred, or -1.
  double heightRatio = 1.0;  ///< Height of the hips above the feet: the character's over the other's; > 0.
};

[[nodiscard]] CommonStance findCommonStance(const ClipBodies& bodies);

/// The clip's channels for the character's nodes. Bones that would not leave their rest pose have none.
/// @param budget  nodes times samples that may still be taken; below 0 afterwards: the rest is left out
[[nodiscard]] std::vector<Channel> retargetedChannels(const ClipBodies& bodies, const CommonStance& stance,
                                                      const AnimationClip& clip, double& budget);

}  // namespace sinew
