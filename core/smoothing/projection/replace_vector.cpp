// core/smoothing/projection/replace_vector.cpp: memory for the kernel, and what it leaves to the scalar path.
#include "core/smoothing/projection/replace_vector.h"

#include <algorithm>

#include "core/smoothing/patches/patch.h"
#include "core/smoothing/projection/replace_kernel.h"
#include "core/smoothing/projection/tile_ranges.h"

namespace sinew {

void replaceInTiles(const ControlMesh& mesh, const FieldView& field, const ReplaceSettings& settings,
                    const FlatVertices& flat, const ImplicitWeights& weights, const VertexTiles& tiles,
                    InstructionSet set, Surface& surface, ProjectionScratch& scratch) {
  scratch.omega.resize(surface.positions.size());
  interpolateValues(mesh, *surface.refinement, weights.omega, scratch.omega);
  const std::size_t ranges = forTileRanges(tiles, scratch, [&](std::span<const VertexTile> asked, std::size_t range) {
    ReplaceFrame frame{
        &tiles, asked, field, settings, flat, weights.wraps, scratch.omega, &surface, &scratch.tiles[range]};
    replaceKernel(set)(frame);
  });

  SmoothingReport& report = surface.report;
  report.uncertified = 0;
  scratch.counts = {};
  scratch.roots.evaluations = {};
  for (std::size_t range = 0; range < ranges; ++range) {
    const TileScratch& used = scratch.tiles[range];
    report.uncertified += static_cast<int>(used.uncertified.size());
    scratch.roots.evaluations.field += used.lanes.evaluations;
    add(used.counts, scratch.counts);
    for (const std::vector<int>* left : {&used.uncertified, &used.shaped}) {
      for (const int vertex : *left) {
        replaceVertex(carriedVertex(mesh, *surface.refinement, vertex), field, settings, flat, weights, surface,
                      scratch);
      }
    }
  }
  tell(scratch, report);
}

void replaceAsChosen(const ControlMesh& mesh, const FieldView& field, const ReplaceSettings& settings,
                     const FlatVertices& flat, const ImplicitWeights& weights, const VertexTiles& tiles,
                     Surface& surface, ProjectionScratch& scratch) {
  const InstructionSet set = chosenInstructionSet();
  if (set == InstructionSet::kScalar || settings.projection != ProjectionKind::kNewton) {
    replace(mesh, field, settings, flat, weights, surface, scratch);
  } else {
    replaceInTiles(mesh, field, settings, flat, weights, tiles, set, surface, scratch);
  }
}

}  // namespace sinew
