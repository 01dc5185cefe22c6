// app/viewport/tools/gizmo_shape.h: the handles of a shape: its thickest section and the middle of its axis.
#pragma once

#include <optional>

#include "app/viewport/tools/gizmo_way.h"
#include "sinew/geometry/ellipsoid.h"

namespace sinew::app {

/// Where the axis is at half its length, from the center, bone space.
[[nodiscard]] glm::vec3 axisMiddleInBone(const Placement& inBone);

/// A point of the thickest section between two poles, from the center, bone space: of the four the one that looks most
/// towards `toEye`.
/// @param toEye  bone space
[[nodiscard]] glm::vec3 thickestInBone(const Placement& inBone, const glm::vec3& toEye);

/// The belly moved along the axis.
/// @param traveled  in radii y of the start. @param typed  the belly itself
[[nodiscard]] Placement withBelly(const Placement& start, float traveled, float reach, std::optional<float> typed);

/// The middle of the axis moved sideways.
/// @param way  X, Z, or both. @param traveled  in radii of the start. @param typed  the bend along the way, or X
[[nodiscard]] Placement withBend(const Placement& start, Way way, const glm::vec3& traveled, float reach,
                                 std::optional<float> typed);

}  // namespace sinew::app
