// core/surface/projection/tile_ranges.h: a frame's tiles, shared out among threads.
#pragma once

#include <algorithm>
#include <span>

#include "core/geometry/parallel.h"
#include "core/surface/projection/projection_scratch.h"
#include "core/surface/projection/vertex_tiles.h"

namespace sinew {

inline constexpr std::size_t kTilesInRange = 16;   ///< Fewer are not worth another thread's trouble.
inline constexpr std::size_t kRangesOfThread = 4;  ///< So that one with little to do can help.

/// Room for what a range of so many tiles may need.
void makeRoom(const VertexTiles& tiles, std::size_t range, TileScratch& scratch);

/// Sums what the first `ranges` scratches have counted, and adds it to the report.
void tellOfRanges(std::size_t ranges, ProjectionScratch& scratch, SmoothingReport& report);

/// Shares the tiles out among threads: calls moveTiles(tiles, scratch) for parts of them, each with a scratch of its
/// own, and moveVertex(vertex, scratch) for every vertex that it left uncertified.
template <class MoveTiles, class MoveVertex>
void projectTiles(const VertexTiles& tiles, ProjectionScratch& scratch, SmoothingReport& report, MoveTiles moveTiles,
                  MoveVertex moveVertex) {
  const std::size_t count = tiles.tiles.size();
  const std::size_t ranges =
      std::clamp(count / kTilesInRange, std::size_t{1}, kRangesOfThread * static_cast<std::size_t>(threadCount()));
  scratch.tiles.resize(std::max(scratch.tiles.size(), ranges));
  forEachIndex(ranges, 1, [&](std::size_t range) {
    TileScratch& own = scratch.tiles[range];
    const std::size_t begin = count * range / ranges;
    const std::size_t end = count * (range + 1) / ranges;
    makeRoom(tiles, end - begin, own);
    moveTiles(std::span(tiles.tiles).subspan(begin, end - begin), own);
    for (const int vertex : own.uncertified) moveVertex(vertex, own.vertices);
  });
  tellOfRanges(ranges, scratch, report);
}

}  // namespace sinew
