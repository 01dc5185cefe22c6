#pragma once  // tests/support/oracle_rise.h: rise directions of the bind pose, in double (docs/design.md).

#include <vector>

#include "core/mesh/control_mesh.h"
#include "tests/support/oracle_math.h"

namespace sinew::oracle {

/// Vertex normals averaged along the edges on which they converge, at most 60 degrees off the normal.
/// @param rise  world units that an edge should allow.  @return [V] unit.
std::vector<Vec> relaxedDirections(const ControlMesh& mesh, double rise);

}  // namespace sinew::oracle
