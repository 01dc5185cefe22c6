// core/smoothing/projection/swell_vector.cpp: memory for the kernel, and what it leaves to the scalar path.
#include "core/smoothing/projection/swell_vector.h"

#include <algorithm>

#include "core/smoothing/projection/swell_kernel.h"

namespace sinew {

void swellInTiles(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
                  const SwellTiles& tiles, InstructionSet set, Surface& surface, ProjectionScratch& scratch) {
  const auto grow = [](auto& items, std::size_t size) {
    if (items.size() < size) items.resize(size);
  };
  grow(scratch.lanes.terms, tiles.mostCandidates);
  grow(scratch.lanes.sums, tiles.mostSlots);
  grow(scratch.walk.spans, tiles.mostCandidates);
  grow(scratch.nearInTile, tiles.mostCandidates);
  scratch.lanes.evaluations = 0;
  scratch.uncertified.clear();
  scratch.uncertified.reserve(surface.positions.size());
  scratch.shaped.clear();
  scratch.shaped.reserve(surface.positions.size());

  SwellFrame frame{&tiles,
                   field,
                   settings,
                   rise,
                   &surface,
                   &scratch.lanes,
                   &scratch.nearInTile,
                   &scratch.walk.spans,
                   &scratch.uncertified,
                   &scratch.shaped,
                   {}};
  swellKernel(set)(frame);
  surface.report.projected += frame.counts.projected - static_cast<int>(scratch.uncertified.size());
  surface.report.uncertified = static_cast<int>(scratch.uncertified.size());
  surface.report.residualMax = std::max(surface.report.residualMax, static_cast<double>(frame.counts.residualMax));
  scratch.roots.evaluations = {scratch.lanes.evaluations, 0};
  for (const std::vector<int>* left : {&scratch.uncertified, &scratch.shaped}) {
    for (const int vertex : *left) {
      swellVertex(carriedVertex(mesh, *surface.refinement, vertex), field, settings, rise, surface, scratch);
    }
  }
  surface.report.evaluations = scratch.roots.evaluations;
}

void swellAsChosen(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
                   const SwellTiles& tiles, Surface& surface, ProjectionScratch& scratch) {
  const InstructionSet set = chosenInstructionSet();
  if (set == InstructionSet::kScalar || settings.projection != ProjectionKind::kNewton) {
    swell(mesh, field, settings, rise, surface, scratch);
  } else {
    swellInTiles(mesh, field, settings, rise, tiles, set, surface, scratch);
  }
}

}  // namespace sinew
