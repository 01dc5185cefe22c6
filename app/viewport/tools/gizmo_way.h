// app/viewport/tools/gizmo_way.h: the ways a gizmo's handle may go: along or about an axis, in a plane, or without a
// constraint.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

namespace sinew::app {

/// kWhole: move in the picture's plane, rotate about the line of sight, scale all three radii.
enum class Way { kNone, kX, kY, kZ, kXY, kYZ, kZX, kWhole };

inline constexpr std::array<Way, 3> kAxisWays = {Way::kX, Way::kY, Way::kZ};
inline constexpr std::array<Way, 3> kPlaneWays = {Way::kXY, Way::kYZ, Way::kZX};
inline constexpr std::array<Way, 7> kAllWays = {Way::kX,  Way::kY,  Way::kZ,    Way::kXY,
                                                Way::kYZ, Way::kZX, Way::kWhole};  ///< Without kNone.

[[nodiscard]] constexpr bool isAxis(Way way) { return way >= Way::kX && way <= Way::kZ; }
[[nodiscard]] constexpr bool isPlane(Way way) { return way >= Way::kXY && way <= Way::kZX; }

/// 0..2: component of a vector along the axis.
[[nodiscard]] constexpr int axisOf(Way axis) {
  assert(isAxis(axis));
  return static_cast<int>(axis) - static_cast<int>(Way::kX);
}

/// The two axes that span a plane: xy: 0, 1; yz: 1, 2; zx: 2, 0.
[[nodiscard]] constexpr std::array<int, 2> planeAxes(Way plane) {
  assert(isPlane(plane));
  const int first = static_cast<int>(plane) - static_cast<int>(Way::kXY);
  return {first, (first + 1) % 3};
}

/// The axis that a plane does not hold.
[[nodiscard]] constexpr int normalAxisOf(Way plane) { return (planeAxes(plane)[0] + 2) % 3; }

/// Index into an array with an element for each of kAllWays.
[[nodiscard]] constexpr std::size_t trackOf(Way way) {
  assert(way != Way::kNone);
  return static_cast<std::size_t>(way) - static_cast<std::size_t>(Way::kX);
}

/// "X", "YZ" ...; "" for kNone and kWhole.
[[nodiscard]] constexpr const char* nameOf(Way way) {
  constexpr std::array<const char*, 8> names = {"", "X", "Y", "Z", "XY", "YZ", "ZX", ""};
  return names[static_cast<std::size_t>(way)];
}

}  // namespace sinew::app
