// tests/support/surface/visible_backs.h: where a surface shows its inside.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "sinew/surface/refinement.h"

namespace sinew::test {

/// Pixels in which the nearest triangle shows its back, summed over pictures from 14 sides without perspective.
/// @param center, extent  what each picture shows: a square of this side, world units.  @param pixels  along its side.
[[nodiscard]] long long visibleBacks(const Refinement& refinement, const std::vector<glm::vec3>& positions,
                                     const glm::vec3& center, float extent, int pixels);

}  // namespace sinew::test
