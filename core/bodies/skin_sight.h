// core/bodies/skin_sight.h: what of a surface an eye can see from anywhere outside of it.
#pragma once

#include "core/geometry/triangle_tree.h"

namespace sinew {

/// Whether any of 256 directions leads away from a place without meeting a triangle.
/// @param normal  any length: directions below it do not count  @param off  distance along it to begin at
[[nodiscard]] bool isSeen(const TriangleTree& triangles, const glm::vec3& place, const glm::vec3& normal, float off);

}  // namespace sinew
