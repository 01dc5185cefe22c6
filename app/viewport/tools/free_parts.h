// app/viewport/tools/free_parts.h: the parts of a picture that nothing lies over.
#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace sinew::app {

inline constexpr float kLeastPart = 0.35f;  ///< Of the picture's width and of its height: less is no room.

/// Rectangles with nothing over them, among them all that cannot be larger in any direction. All rectangles are low x
/// and y, high x and y, 0..1 of the picture. Nothing free is large enough: what covers most is passed over, and so on.
[[nodiscard]] std::vector<glm::vec4> freeParts(std::span<const glm::vec4> covered);

}  // namespace sinew::app
