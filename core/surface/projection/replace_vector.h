// core/surface/projection/replace_vector.h: `replace` in tiles of 16, with replace() as reference and refuge.
// docs/performance.md.
#pragma once

#include "core/geometry/instruction_set.h"
#include "core/surface/projection/replace.h"
#include "core/surface/projection/vertex_tiles.h"

namespace sinew {

/// As replace() by newton, to 1e-6 H where roots are certain, and vertex by vertex where they are not. All
/// instruction sets and any number of threads give the same bits.
/// @param tiles  of the field's lists.  @param set  not kScalar; one that this machine runs.
void replaceInTiles(const ControlMesh& mesh, const FieldView& field, const ReplaceSettings& settings,
                    const FlatVertices& flat, const ImplicitWeights& weights, const VertexTiles& tiles,
                    InstructionSet set, Surface& surface, ProjectionScratch& scratch);

}  // namespace sinew
