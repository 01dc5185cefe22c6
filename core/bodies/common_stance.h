// core/bodies/common_stance.h: what turns another body's bind pose into the stance of the character's.
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "core/character/body_slots.h"
#include "sinew/character/skeleton.h"

namespace sinew {

/// Two skeletons and what is known of them. Outlives what is made of it.
struct ClipBodies {
  const Skeleton& from;  ///< Whose clips are played.
  const Skeleton& to;    ///< Who plays them.
  const BodySlots& fromSlots;
  const BodySlots& toSlots;
  const std::vector<int>& partner;  ///< [bones of to] bone of from, or -1
};

/// The character's bone that is this part, or whose partner is: feet that are targets of their legs, not below them,
/// are found by their names alone. -1: none.
[[nodiscard]] int partOf(const ClipBodies& bodies, BodySlot slot);

struct CommonStance {
  /// World of the clips -> world of the character: about y, by whole quarters, so that both face the same way.
  glm::dquat facing{1.0, 0.0, 0.0, 0.0};
  /// [bones of to] Turns the partner, as it stands in its bind pose, to lie as the bone does. World of the character.
  /// Arms and legs: the least rotation, from the trunk outwards. Hands go with the arms; trunk, head and feet keep the
  /// stance they have.
  std::vector<glm::dquat> turn;
  int hips = -1;             ///< The bone of the character whose translation is transferred, or -1.
  double heightRatio = 1.0;  ///< Hips above the feet: the character's by the other's; > 0.
};

[[nodiscard]] CommonStance findCommonStance(const ClipBodies& bodies);

/// The rotation in a matrix; none where it is too flat to have one.
[[nodiscard]] glm::dquat rotationIn(const glm::mat4& matrix);

}  // namespace sinew
