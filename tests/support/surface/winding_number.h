// tests/support/surface/winding_number.h: whether a point lies in a mesh, the slow way.
#pragma once

#include <glm/vec3.hpp>

#include "sinew/character/character.h"

namespace sinew::test {

/// How often the bind pose's mesh goes round a point (van Oosterom & Strackee 1983): above 0.5 it lies inside.
[[nodiscard]] double windingNumber(const ControlMesh& mesh, const glm::dvec3& point);

}  // namespace sinew::test
