// core/geometry/edges.h: the edges of a triangle list.
#pragma once

#include "sinew/geometry/control_mesh.h"

namespace sinew {

/// Fills the mesh's edges, in order of first use, and those of its triangles, from the triangles' vertices.
void findEdges(ControlMesh& mesh);

}  // namespace sinew
