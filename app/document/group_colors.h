// app/document/group_colors.h: the colors of groups and of territories, the same in picture and panels.
#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "sinew/rig/rig.h"

namespace sinew::app {

/// Colors that stay apart with protanopia and deuteranopia too, and from kTerritoryColor. Neighbors differ most.
inline constexpr int kGroupColors = 8;

/// sRGB, 0..1. From kGroupColors on paler and darker turns of the same. @param slot  >= 0
[[nodiscard]] glm::vec3 groupColor(int slot);

/// Which color a group has: it keeps it whatever happens to the groups beside it. @param group  index into Rig::groups
[[nodiscard]] int colorSlot(const Rig& rig, int group);

/// sRGB, by name; gray for a group that is not there.
[[nodiscard]] glm::vec3 groupColor(const Rig& rig, const std::string& group);

/// sRGB: the skin that a muscle may move, and the bones it follows.
inline constexpr glm::vec3 kTerritoryColor{0.665f, 0.485f, 0.965f};

/// sRGB -> linear.
[[nodiscard]] glm::vec3 toLinear(const glm::vec3& srgb);

}  // namespace sinew::app
