// app/viewport/render/framing.h: views that hold something wholly and tightly.
#pragma once

#include <span>
#include <vector>

#include "app/viewport/render/view.h"

namespace sinew::app {

inline constexpr float kFieldOfView = 0.55f;    ///< Radians, along the picture's height.
inline constexpr float kDefaultMargin = 0.08f;  ///< Part of the picture left free on each side.

/// Camera axes for angles in radians. yaw 0 looks at the front (from +Z towards -Z), positive yaw moves the eye to +X;
/// positive pitch lifts the eye. Columns: right, up, backward (towards the eye).
[[nodiscard]] glm::mat3 cameraAxes(float yaw, float pitch);

/// The nearest eye for which all points lie inside the picture less its margin, exactly (no search). Near and far
/// planes leave room for a ground around them. No points: the unit box.
/// @param margin 0..0.45, part of width and height left free on each side.
[[nodiscard]] View framedView(std::span<const glm::vec3> points, float yaw, float pitch, const glm::ivec2& size,
                              bool orthographic, float margin = kDefaultMargin);
[[nodiscard]] View framedView(const Bounds& bounds, float yaw, float pitch, const glm::ivec2& size, bool orthographic,
                              float margin = kDefaultMargin);

/// View from given axes: eye at target + backward * distance. Orthographic: shows what a perspective eye at that
/// distance would show at the target. Near and far planes suit a scene of about `reach` around the target.
[[nodiscard]] View orbitView(const glm::vec3& target, float yaw, float pitch, float distance, const glm::ivec2& size,
                             bool orthographic, float reach);

/// The points furthest along a fixed, even set of directions: few points that frame as all of them do, nearly.
[[nodiscard]] std::vector<glm::vec3> extremePoints(std::span<const glm::vec3> points);

}  // namespace sinew::app
