// core/bodies/sculpt_heights.h: how high a sculpted body lies over the character's own skin.
#pragma once

#include <cstdint>
#include <vector>

#include "core/bodies/height_model.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/geometry/result.h"

namespace sinew {

struct SculptHeights {
  std::vector<float> heights;       ///< [P] along the points' directions, world units; 0 if not known.
  std::vector<std::uint8_t> known;  ///< [P]
  float covered = 0.0f;             ///< Part of the area that muscles can move for which heights are known.
};

/// Where the lines along which the skin rises meet the sculpt, whatever its triangles are: the nearest meeting within
/// 10 % of H whose face looks the same way. Meetings far from those of their neighbors are not used. A coarse sculpt is
/// rounded first, as the skin is. Error: it is of another size or in another place, in another pose, or covers less
/// than half of the skin.
/// @param sculpt  welded, in the character's bind pose and units  @param height  H
[[nodiscard]] Result<SculptHeights> sculptHeights(const SkinPoints& points, const ControlMesh& sculpt, float height);

}  // namespace sinew
