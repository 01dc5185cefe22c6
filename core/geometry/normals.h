// core/geometry/normals.h: vertex normals from faces.
#pragma once

#include <span>
#include <vector>

#include "sinew/geometry/control_mesh.h"

namespace sinew {

/// One unit normal per vertex: face normals weighted by the corner's angle (Thuermer & Wuethrich 1998), so that it does
/// not depend on how the faces are cut into triangles. A vertex whose faces cancel or have no area gets +Y.
/// @param positions [V] any space.  @return [V] same space.
[[nodiscard]] std::vector<glm::vec3> vertexNormals(std::span<const glm::vec3> positions,
                                                   std::span<const ControlTriangle> triangles);

/// The same for some vertices only.
/// @param asked [V] which.  @param normals [V] only those asked for are written.
void updateVertexNormals(std::span<const glm::vec3> positions, std::span<const ControlTriangle> triangles,
                         const std::vector<bool>& asked, std::span<glm::vec3> normals);

}  // namespace sinew
