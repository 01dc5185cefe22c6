// core/surface/projection/tile_projection.cpp: tiles go to the kernels in ranges, uncertain vertices to scalar code.
#include "core/surface/projection/tile_projection.h"

#include <algorithm>

#include "core/geometry/parallel.h"
#include "core/surface/patches/patch.h"

namespace sinew {
namespace {

constexpr std::size_t kTilesInRange = 16;   ///< Fewer are not worth another thread.
constexpr std::size_t kRangesOfThread = 4;  ///< So that idle threads can help.

/// Makes room for a range of that many tiles.
void makeRoom(const VertexTiles& tiles, const CliqueSizes& most, std::size_t range, TileScratch& scratch) {
  const auto grow = [](auto& items, std::size_t size) {
    if (items.size() < size) items.resize(size);
  };
  grow(scratch.lanes.terms, tiles.mostCandidates);
  grow(scratch.lanes.shapes, tiles.mostCandidates);
  grow(scratch.lines, tiles.mostCandidates);
  grow(scratch.lanes.sums, most.slots);
  grow(scratch.lanes.levels, most.levels);
  grow(scratch.lanes.shares, most.cliques);
  scratch.lanes.sharing.reserve(most.cliques);
  scratch.lanes.present.makeRoom(most.levels, most.slots, most.inCliques);
  grow(scratch.spans, tiles.mostCandidates);
  grow(scratch.near, tiles.mostCandidates);
  scratch.counts = {};
  scratch.vertices.counts = {};
  scratch.uncertified.clear();
  scratch.uncertified.reserve(range * kLanes);
}

/// Calls moveTiles(tiles, scratch) for ranges of tiles on all cores, each range with its own scratch, and
/// moveVertex(vertex, scratch) for every vertex left uncertified. Adds the counts to the report.
template <class MoveTiles, class MoveVertex>
void projectTiles(const VertexTiles& tiles, const FieldView& field, ProjectionScratch& scratch, SmoothingReport& report,
                  MoveTiles moveTiles, MoveVertex moveVertex) {
  CliqueSizes most = field.lists->most;
  if (field.posedSets) most.cover(field.posedSets->most());
  const std::size_t count = tiles.tiles.size();
  const std::size_t ranges =
      std::clamp(count / kTilesInRange, std::size_t{1}, kRangesOfThread * static_cast<std::size_t>(threadCount()));
  scratch.tiles.resize(std::max(scratch.tiles.size(), ranges));
  forEachIndex(ranges, 1, [&](std::size_t range) {
    TileScratch& own = scratch.tiles[range];
    const std::size_t begin = count * range / ranges;
    const std::size_t end = count * (range + 1) / ranges;
    makeRoom(tiles, most, end - begin, own);
    moveTiles(std::span(tiles.tiles).subspan(begin, end - begin), own);
    for (const int vertex : own.uncertified) moveVertex(vertex, own.vertices);
  });
  scratch.counts = {};
  report.uncertified = 0;
  for (const TileScratch& range : std::span(scratch.tiles).first(ranges)) {
    report.uncertified += static_cast<int>(range.uncertified.size());
    add(range.counts, scratch.counts);
    add(range.vertices.counts, scratch.counts);
  }
  addToReport(scratch.counts, report);
}

}  // namespace

void swellInTiles(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
                  const VertexTiles& tiles, Surface& surface, ProjectionScratch& scratch) {
  const SwellKernel kernel = swellKernel(chosenVectorSet());
  const auto moveTiles = [&](std::span<const VertexTile> asked, TileScratch& range) {
    SwellInputs inputs{&tiles, asked, field, settings, rise, &surface, &range};
    kernel(inputs);
  };
  const auto moveVertex = [&](int vertex, VertexScratch& range) {
    swellVertex(carriedVertex(mesh, *surface.refinement, vertex), field, settings, rise, surface, range);
  };
  projectTiles(tiles, field, scratch, surface.report, moveTiles, moveVertex);
}

void replaceInTiles(const ControlMesh& mesh, const FieldView& field, const ReplaceSettings& settings,
                    const FlatVertices& flat, const ImplicitWeights& weights, const VertexTiles& tiles,
                    Surface& surface, ProjectionScratch& scratch) {
  scratch.omega.resize(surface.positions.size());
  interpolateValues(mesh, *surface.refinement, weights.omega, scratch.omega);
  const ReplaceKernel kernel = replaceKernel(chosenVectorSet());
  const auto moveTiles = [&](std::span<const VertexTile> asked, TileScratch& range) {
    ReplaceInputs inputs{&tiles, asked, field, settings, flat, weights.wraps, scratch.omega, &surface, &range};
    kernel(inputs);
  };
  const auto moveVertex = [&](int vertex, VertexScratch& range) {
    replaceVertex(carriedVertex(mesh, *surface.refinement, vertex), field, settings, flat, weights, surface, range);
  };
  projectTiles(tiles, field, scratch, surface.report, moveTiles, moveVertex);
}

}  // namespace sinew
