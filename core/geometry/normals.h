// core/geometry/normals.h: vertex normals from faces, creases, and flat matrices.
#pragma once

#include <span>
#include <vector>

#include <glm/mat3x3.hpp>

#include "sinew/geometry/control_mesh.h"

namespace sinew {

inline constexpr float kNoCreases = 180.0f;  ///< The crease angle without creases.

/// The same mesh with its wedges split at creases; everything else stays bit for bit. The corners of a vertex form fans
/// of faces, joined by edges across which the surface bends by at most `degrees` (to 0.01 degrees, in the bind pose).
/// If a vertex has more than one fan, its wedges are creased, each with the angle-weighted normal of its fan. Borders
/// join nothing. At an edge with more than two triangles, those that continue each other smoothly are joined. A
/// triangle without area has the direction of its neighbor across its longest edge.
/// @param mesh welded, no wedge creased.  @param degrees 0..180; kNoCreases gives the mesh itself.
[[nodiscard]] ControlMesh creased(const ControlMesh& mesh, float degrees);

[[nodiscard]] bool hasCreases(const ControlMesh& mesh);  ///< Whether any wedge is creased.

/// The columns span no volume up to rounding of floats: the determinant is at most a millionth of the product of their
/// lengths. Independent of scale along the columns. True for matrices that are not finite. The only test of this kind,
/// so that muscles of a bone can be edited exactly if they can be mirrored and are visible.
[[nodiscard]] bool isFlat(const glm::dmat3& matrix);

/// One unit normal per vertex: face normals weighted by the angle of the corner (Thuermer & Wuethrich 1998), so that it
/// does not depend on how faces are triangulated. +Y for a vertex whose faces cancel or have no area.
/// @param positions [V] any space.  @return [V] same space.
[[nodiscard]] std::vector<glm::vec3> vertexNormals(std::span<const glm::vec3> positions,
                                                   std::span<const ControlTriangle> triangles);

/// The same for some vertices. @param asked [V] which.  @param normals [V] only theirs are written.
void updateVertexNormals(std::span<const glm::vec3> positions, std::span<const ControlTriangle> triangles,
                         const std::vector<bool>& asked, std::span<glm::vec3> normals);

}  // namespace sinew
