// core/surface/projection/tile_projection.cpp: kernels for the tiles, swellVertex() for what they leave.
#include "core/surface/projection/tile_projection.h"

#include "core/surface/patches/patch.h"

namespace sinew {

// Kernels for the tiles, replaceVertex() for what they leave.

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

// Memory for a range of tiles, and what all of them counted.

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
