#pragma once  // core/smoothing/face_culling.h: control triangles the eye cannot see, before projection (paper 4.3).

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/control_mesh.h"
#include "core/smoothing/carrier_walk.h"
#include "core/smoothing/refinement.h"

namespace sinew {

/// What the eye may skip in one pose. A mark of 1 means skipped.
struct FaceCulling {
  std::vector<std::uint8_t> triangles;  ///< [T] neither projected nor drawn.
  std::vector<std::uint8_t> carriers;   ///< [V+E+T] not projected: touched by culled triangles alone.
  int culled = 0;                       ///< Triangles.
};

/// Marks the triangles whose three vertex normals point away from the eye (paper 4.3). Two conditions more, for the paper's
/// own does remove visible pixels: all small triangles of the patch face away too, as a patch curves between its corners;
/// and where a primitive reaches the triangle, which may tilt the skin by any angle, the normals point at least 30 degrees
/// beyond the horizon.
/// @param patchPositions [V'] world, before projection.  @param normals [V] skinned control normals, unit.
[[nodiscard]] FaceCulling cullFaces(const ControlMesh& mesh, const Refinement& refinement, const FieldView& field,
                                    std::span<const glm::vec3> patchPositions, std::span<const glm::vec3> normals,
                                    const glm::vec3& eye);

}  // namespace sinew
