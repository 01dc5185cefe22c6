// app/panels/blending_layout.h: where the nodes of the blending graph stand when nobody has placed them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace sinew::app {

inline constexpr float kNodeSpacing = 92.0f;  ///< Length an edge strives for, design pixels.

/// Places for all nodes around the origin, design pixels, y down: linked ones near each other, none on another, the
/// same graph always the same. Springs and repulsion from a circle, a fixed number of steps (after Fruchterman and
/// Reingold, Software: Practice and Experience 21(11), 1991).
/// @param links  pairs of nodes < count
[[nodiscard]] std::vector<glm::vec2> layoutGraph(int count, std::span<const std::array<int, 2>> links);

/// A place for one more: the nearest to the origin on a spiral that keeps its distance from all.
[[nodiscard]] glm::vec2 freePlace(std::span<const glm::vec2> taken);

}  // namespace sinew::app
