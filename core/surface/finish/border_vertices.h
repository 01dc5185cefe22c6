// core/surface/finish/border_vertices.h: where the surface is open.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// [V'] 1: on an edge with a single triangle. (Where more than two meet they share their vertices: nothing can open.)
[[nodiscard]] std::vector<std::uint8_t> borderVertices(const ControlMesh& mesh, const Refinement& refinement);

}  // namespace sinew
