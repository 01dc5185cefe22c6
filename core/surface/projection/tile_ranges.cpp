// core/surface/projection/tile_ranges.cpp: memory for a range of tiles, and what all of them counted.
#include "core/surface/projection/tile_ranges.h"

namespace sinew {

void makeRoom(const VertexTiles& tiles, std::size_t range, TileScratch& scratch) {
  const auto grow = [](auto& items, std::size_t size) {
    if (items.size() < size) items.resize(size);
  };
  grow(scratch.lanes.terms, tiles.mostCandidates);
  grow(scratch.lanes.shapes, tiles.mostCandidates);
  grow(scratch.lines, tiles.mostCandidates);
  grow(scratch.lanes.sums, tiles.mostSlots);
  grow(scratch.spans, tiles.mostCandidates);
  grow(scratch.near, tiles.mostCandidates);
  scratch.counts = {};
  scratch.vertices.counts = {};
  scratch.uncertified.clear();
  scratch.uncertified.reserve(range * kLanes);
}

void tellOfRanges(std::size_t ranges, ProjectionScratch& scratch, SmoothingReport& report) {
  scratch.counts = {};
  report.uncertified = 0;
  for (const TileScratch& range : std::span(scratch.tiles).first(ranges)) {
    report.uncertified += static_cast<int>(range.uncertified.size());
    for (const VertexCounts* counts : {&range.counts, &range.vertices.counts}) add(*counts, scratch.counts);
  }
  tell(scratch, report);
}

}  // namespace sinew
