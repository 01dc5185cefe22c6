// core/surface/projection/swell_vector.cpp: kernels for the tiles, swellVertex() for what they leave.
#include "core/surface/projection/swell_vector.h"

#include "core/surface/projection/swell_kernel.h"
#include "core/surface/projection/tile_ranges.h"

namespace sinew {

void swellInTiles(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
                  const VertexTiles& tiles, InstructionSet set, Surface& surface, ProjectionScratch& scratch) {
  const auto moveTiles = [&](std::span<const VertexTile> asked, TileScratch& range) {
    SwellInputs inputs{&tiles, asked, field, settings, rise, &surface, &range};
    swellKernel(set)(inputs);
  };
  const auto moveVertex = [&](int vertex, VertexScratch& range) {
    swellVertex(carriedVertex(mesh, *surface.refinement, vertex), field, settings, rise, surface, range);
  };
  projectTiles(tiles, scratch, surface.report, moveTiles, moveVertex);
}

}  // namespace sinew
