// core/surface/projection/swell_vector.h: `swell` in tiles of 16, with swell() as reference and refuge.
// docs/performance.md.
#pragma once

#include "core/geometry/instruction_set.h"
#include "core/surface/projection/swell.h"
#include "core/surface/projection/vertex_tiles.h"

namespace sinew {

/// As swell() by newton, to 1e-6 H: 16 vertices at a time, and vertex by vertex where the first root is
/// not certain (TileScratch::uncertified). All instruction sets and any number of threads give the same bits, and a
/// vertex gets the same whatever lies beside it.
/// @param tiles  of the field's lists.  @param set  not kScalar; one that this machine runs.
void swellInTiles(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
                  const VertexTiles& tiles, InstructionSet set, Surface& surface, ProjectionScratch& scratch);

}  // namespace sinew
