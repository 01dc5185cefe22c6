// app/document/group_colors.h: colors of groups and territories, in picture and panels.
#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "sinew/rig/rig.h"

namespace sinew::app {

/// The colors stay distinct with protanopia and deuteranopia, and from kTerritoryColor.
inline constexpr int kGroupColors = 8;

/// sRGB, 0..1. Paler and darker variants from kGroupColors on. @param slot  >= 0
[[nodiscard]] glm::vec3 groupColor(int slot);

/// The group's color slot, which it keeps for life. @param group  index into Rig::groups
[[nodiscard]] int colorSlot(const Rig& rig, int group);

/// sRGB, by name; gray for an unknown group.
[[nodiscard]] glm::vec3 groupColor(const Rig& rig, const std::string& group);

/// sRGB: the skin that a muscle may move, and its bones.
inline constexpr glm::vec3 kTerritoryColor{0.665f, 0.485f, 0.965f};

/// sRGB -> linear.
[[nodiscard]] glm::vec3 toLinear(const glm::vec3& srgb);

}  // namespace sinew::app
