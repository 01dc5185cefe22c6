// core/files/gltf/triangle_modes.h: which corners the triangles of a list, strip or fan have.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <tiny_gltf.h>

namespace sinew::gltf {

/// @param mode  TINYGLTF_MODE_TRIANGLES, _TRIANGLE_STRIP or _TRIANGLE_FAN
[[nodiscard]] inline std::size_t triangleCount(int mode, std::size_t corners) {
  if (mode == TINYGLTF_MODE_TRIANGLES) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

/// Corner numbers of a triangle; every second one of a strip is turned so that all face the same way.
[[nodiscard]] inline std::array<std::uint32_t, 3> triangleCorners(int mode, std::size_t triangle) {
  const auto t = static_cast<std::uint32_t>(triangle);
  if (mode == TINYGLTF_MODE_TRIANGLES) return {3 * t, 3 * t + 1, 3 * t + 2};
  if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {t + 1, t + 2, 0};
  return {t, t + 1 + t % 2, t + 2 - t % 2};
}

}  // namespace sinew::gltf
