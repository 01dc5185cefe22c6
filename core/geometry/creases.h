// core/geometry/creases.h: sharp edges: normals for shading, split where faces meet at more than an angle.
#pragma once

#include "sinew/geometry/control_mesh.h"

namespace sinew {

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

}  // namespace sinew
