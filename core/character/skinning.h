#pragma once  // core/character/skinning.h: linear blend skinning of the control mesh.

#include <span>
#include <vector>

#include "core/character/character.h"
#include "core/skeleton/pose.h"

namespace sinew {

/// The control mesh in a pose. World space.
struct SkinnedMesh {
  std::vector<glm::vec3> positions;  ///< [V]
  std::vector<glm::vec3> normals;    ///< [V] unit.
};

/// Each vertex follows the weighted sum of its bindings' matrices; its normal the inverse transpose of that sum.
/// In the bind pose the result is the control mesh itself to rounding. Reuses the output's memory.
void skin(const Character& character, const Pose& pose, SkinnedMesh& out);

}  // namespace sinew
