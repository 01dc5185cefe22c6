// core/surface/face_culling.h: back-face culling as in the paper (4.3), for comparison.
#pragma once

#include <cstdint>
#include <vector>

#include "core/character/skinning.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Marks of one pose and eye; 1: not projected.
struct FaceCulling {
  std::vector<std::uint8_t> carriers;  ///< [V+E+T] only at culled triangles. Empty: nothing is.
  int culled = 0;                      ///< Control triangles.
};

/// Culls control triangles whose three vertex normals point away from the eye. A muscle on one can still be seen past
/// the outline, so a picture of the surface may lack it.  @param control  of the pose.  @param eye  world.
void cullFaces(const ControlMesh& mesh, const Refinement& refinement, const SkinnedMesh& control, const glm::vec3& eye,
               FaceCulling& out);

}  // namespace sinew
