// core/geometry/longest_axis.h: along which axis something is longest.
#pragma once

#include <glm/vec3.hpp>

namespace sinew {

/// The first of equals. @param size  not below 0
[[nodiscard]] inline glm::length_t longestAxis(const glm::vec3& size) {
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

}  // namespace sinew
