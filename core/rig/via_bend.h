// core/rig/via_bend.h: a via point bends the muscles on its line. docs/lines.md, Via point.
#pragma once

#include <span>
#include <vector>

#include "core/rig/field.h"
#include "core/rig/line_pose.h"

namespace sinew {

/// How a muscle takes what its via point adds to the line's shift (PosedLine::aside).
struct ViaBend {
  Placement placement;  ///< The muscle's, its y axis along the line where a plain ellipsoid's other axis was.
  float share = 0.0f;   ///< Part of the shift that is a bend; the rest moves the muscle as a whole. 0..1: 1 for a
                        ///< muscle along the line and as long as its belly.
};
/// @param boneInBind  of the bone in whose space the placement is
[[nodiscard]] ViaBend viaBend(const LineRest& rest, const Placement& placement, const glm::mat4& boneInBind);

/// What places a bent muscle in a pose.
struct BentMuscle {
  glm::mat4 carrier{1.0f};
  Placement placement;
};
/// Its middle is where the carrier that shifts it whole has it. Continuous in the shift; without one, the muscle
/// itself.
/// @param carrier  bone space in the bind pose -> world now, with the whole shift  @param shift  world
[[nodiscard]] BentMuscle bentMuscle(const ViaBend& bend, const glm::mat4& carrier, const glm::vec3& shift);

}  // namespace sinew
