// core/smoothing/projection/tile_ranges.cpp: memory for a range of tiles.
#include "core/smoothing/projection/tile_ranges.h"

namespace sinew {

void makeRoom(const VertexTiles& tiles, std::size_t range, TileScratch& scratch) {
  const auto grow = [](auto& items, std::size_t size) {
    if (items.size() < size) items.resize(size);
  };
  grow(scratch.lanes.terms, tiles.mostCandidates);
  grow(scratch.lines, tiles.mostCandidates);
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

}  // namespace sinew
