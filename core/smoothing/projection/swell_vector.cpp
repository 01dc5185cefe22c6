// core/smoothing/projection/swell_vector.cpp: memory for the kernel, and what it leaves to the scalar path.
#include "core/smoothing/projection/swell_vector.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/smoothing/projection/swell_kernel.h"

namespace sinew {
namespace {

constexpr std::size_t kTilesInRange = 16;   ///< Fewer are not worth another thread's trouble.
constexpr std::size_t kRangesOfThread = 4;  ///< So that one with little to do can help.

void makeRoom(const SwellTiles& tiles, std::size_t range, TileScratch& scratch) {
  const auto grow = [](auto& items, std::size_t size) {
    if (items.size() < size) items.resize(size);
  };
  grow(scratch.lanes.terms, tiles.mostCandidates);
  grow(scratch.lanes.sums, tiles.mostSlots);
  grow(scratch.spans, tiles.mostCandidates);
  grow(scratch.near, tiles.mostCandidates);
  scratch.counts = {};
  scratch.lanes.evaluations = 0;
  scratch.uncertified.clear();
  scratch.uncertified.reserve(range * kLanes);
  scratch.shaped.clear();
  scratch.shaped.reserve(range * kLanes);
}

}  // namespace

void swellInTiles(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
                  const SwellTiles& tiles, InstructionSet set, Surface& surface, ProjectionScratch& scratch) {
  const std::size_t count = tiles.tiles.size();
  const std::size_t ranges =
      std::clamp(count / kTilesInRange, std::size_t{1}, kRangesOfThread * static_cast<std::size_t>(threadCount()));
  scratch.tiles.resize(std::max(scratch.tiles.size(), ranges));
  forEachIndex(ranges, 1, [&](std::size_t range) {
    const std::size_t begin = count * range / ranges;
    const std::size_t end = count * (range + 1) / ranges;
    makeRoom(tiles, end - begin, scratch.tiles[range]);
    SwellFrame frame{&tiles,
                     std::span(tiles.tiles).subspan(begin, end - begin),
                     field,
                     settings,
                     rise,
                     &surface,
                     &scratch.tiles[range]};
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
    report.residualMax = std::max(report.residualMax, static_cast<double>(used.counts.residualMax));
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
                   const SwellTiles& tiles, Surface& surface, ProjectionScratch& scratch) {
  const InstructionSet set = chosenInstructionSet();
  if (set == InstructionSet::kScalar || settings.projection != ProjectionKind::kNewton) {
    swell(mesh, field, settings, rise, surface, scratch);
  } else {
    swellInTiles(mesh, field, settings, rise, tiles, set, surface, scratch);
  }
}

}  // namespace sinew
