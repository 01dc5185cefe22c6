// core/surface/projection/replace_vector.cpp: kernels for the tiles, replaceVertex() for what they leave.
#include "core/surface/projection/replace_vector.h"

#include "core/surface/patches/patch.h"
#include "core/surface/projection/replace_kernel.h"
#include "core/surface/projection/tile_ranges.h"

namespace sinew {

void replaceInTiles(const ControlMesh& mesh, const FieldView& field, const ReplaceSettings& settings,
                    const FlatVertices& flat, const ImplicitWeights& weights, const VertexTiles& tiles,
                    InstructionSet set, Surface& surface, ProjectionScratch& scratch) {
  scratch.omega.resize(surface.positions.size());
  interpolateValues(mesh, *surface.refinement, weights.omega, scratch.omega);
  const auto moveTiles = [&](std::span<const VertexTile> asked, TileScratch& range) {
    ReplaceInputs inputs{&tiles, asked, field, settings, flat, weights.wraps, scratch.omega, &surface, &range};
    replaceKernel(set)(inputs);
  };
  const auto moveVertex = [&](int vertex, VertexScratch& range) {
    replaceVertex(carriedVertex(mesh, *surface.refinement, vertex), field, settings, flat, weights, surface, range);
  };
  projectTiles(tiles, scratch, surface.report, moveTiles, moveVertex);
}

}  // namespace sinew
