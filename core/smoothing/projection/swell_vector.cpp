// core/smoothing/projection/swell_vector.cpp: memory for the kernel, and what it leaves to the scalar path.
#include "core/smoothing/projection/swell_vector.h"

#include <algorithm>

#include "core/smoothing/projection/swell_kernel.h"
#include "core/smoothing/projection/tile_ranges.h"

namespace sinew {
void swellInTiles(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
                  const VertexTiles& tiles, InstructionSet set, Surface& surface, ProjectionScratch& scratch) {
  const std::size_t ranges = forTileRanges(tiles, scratch, [&](std::span<const VertexTile> asked, std::size_t range) {
    SwellFrame frame{&tiles, asked, field, settings, rise, &surface, &scratch.tiles[range]};
    swellKernel(set)(frame);
  });

  SmoothingReport& report = surface.report;
  scratch.roots.evaluations = {};
  report.uncertified = 0;
  for (std::size_t range = 0; range < ranges; ++range) {
    const TileScratch& used = scratch.tiles[range];
    const int uncertified = static_cast<int>(used.uncertified.size());
    report.projected += used.counts.projected - uncertified;
    report.uncertified += uncertified;
    report.residualMax = std::max(report.residualMax, used.counts.residualMax);
    scratch.roots.evaluations.field += used.lanes.evaluations;
    for (const std::vector<int>* left : {&used.uncertified, &used.shaped}) {
      for (const int vertex : *left) {
        swellVertex(carriedVertex(mesh, *surface.refinement, vertex), field, settings, rise, surface, scratch);
      }
    }
  }
  report.evaluations = scratch.roots.evaluations;
}

void swellAsChosen(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
                   const VertexTiles& tiles, Surface& surface, ProjectionScratch& scratch) {
  const InstructionSet set = chosenInstructionSet();
  if (set == InstructionSet::kScalar || settings.projection != ProjectionKind::kNewton) {
    swell(mesh, field, settings, rise, surface, scratch);
  } else {
    swellInTiles(mesh, field, settings, rise, tiles, set, surface, scratch);
  }
}

}  // namespace sinew
