// core/rig/belly_on_line.h: the muscle that a line gets where none was drawn: from under the line to over the skin.
#pragma once

#include <algorithm>

#include <glm/gtc/quaternion.hpp>

#include "sinew/geometry/ellipsoid.h"

namespace sinew {

/// How far it stands out of the skin, of its half length.
inline constexpr float kBellyBulge = 0.22f;

/// Its long axis (y) lies along the line, its height (z) points out. World.
/// @param middle  on the line  @param along, out  unit, square to each other
/// @param top  from the middle to the highest point  @param half  half its length
[[nodiscard]] inline Placement bellyOnLine(const glm::vec3& middle, const glm::vec3& along, const glm::vec3& out,
                                           float top, float half) {
  constexpr float kThick = 0.55f;      // Half thickness, of `top`.
  constexpr float kLeastThick = 0.2f;  // Of the half length.
  constexpr float kMostThick = 0.5f;
  constexpr float kWide = 1.1f;  // Width over thickness.
  const float thick = std::clamp(kThick * top, kLeastThick * half, kMostThick * half);
  Placement belly;
  belly.center = middle + (top - thick) * out;
  belly.rotation = glm::normalize(glm::quat_cast(glm::mat3(glm::cross(along, out), along, out)));
  belly.radii = {kWide * thick, half, thick};
  return belly;
}

}  // namespace sinew
