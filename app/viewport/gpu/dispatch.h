// app/viewport/gpu/dispatch.h: work groups of a stage, in two dimensions.
#pragma once

#include <cstdint>

namespace sinew::app {

inline constexpr std::uint32_t kGroupSize = 64;  ///< Invocations: local_size_x of shaders/compute/items.glsl.

/// What every card allows along an axis, and some no more.
inline constexpr std::uint32_t kMostGroupsAlong = 65'535;

struct Groups {
  std::uint32_t x = 0;
  std::uint32_t y = 1;
};

/// So many groups that each of `items` has an invocation; surplus ones have nothing to do.
/// @param most  along an axis
[[nodiscard]] constexpr Groups groupsFor(std::uint32_t items, std::uint32_t most = kMostGroupsAlong) {
  const std::uint32_t groups = (items + kGroupSize - 1) / kGroupSize;
  if (groups <= most) return {groups, 1};
  const std::uint32_t rows = (groups + most - 1) / most;
  return {(groups + rows - 1) / rows, rows};
}

}  // namespace sinew::app
