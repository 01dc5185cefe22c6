// core/geometry/normals.h: vertex normals from faces.
#pragma once

#include <span>
#include <vector>

#include <glm/mat3x3.hpp>

#include "sinew/geometry/control_mesh.h"

namespace sinew {

// Sharp edges: normals for shading, split where faces meet at more than an angle.

/// From this angle on nothing is a crease.
inline constexpr float kNoCreases = 180.0f;

/// The same mesh with its wedges split at creases: positions, normals, influences, edges and the triangles' vertices
/// stay bit for bit, only wedges and the triangles' wedges differ. The corners of a vertex fall into fans: faces joined
/// by edges across which the surface turns by at most `degrees` (to 0.01 degrees, in the bind pose). A vertex with one
/// fan stays as it is; with more, its wedges are creased, each with the normal of its fan's faces, weighted by angle
/// (mesh/normals.h). A border joins nothing. Of an edge with more than two triangles, those that go on smoothly into
/// each other are joined. A triangle without an area goes with its neighbor across its longest edge.
/// @param mesh welded, no wedge creased.  @param degrees 0..180; kNoCreases gives the mesh itself.
[[nodiscard]] ControlMesh creased(const ControlMesh& mesh, float degrees);

/// Whether any wedge is creased.
[[nodiscard]] bool hasCreases(const ControlMesh& mesh);

// Whether a matrix leaves three dimensions.

/// The columns span no volume, but for what rounding to float leaves: their determinant is at most a millionth of the
/// product of their lengths. Scale, even or uneven along the columns, does not matter. True for what is not finite.
/// One answer for all: a bone whose muscles can be edited is one whose muscles can be mirrored and are seen.
[[nodiscard]] bool isFlat(const glm::dmat3& matrix);

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
