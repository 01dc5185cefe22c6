// core/surface/projection/tile_projection.h: `swell` in tiles of 16, with swell() as reference and refuge.
// docs/performance.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/instruction_set.h"
#include "core/geometry/parallel.h"
#include "core/surface/projection/projection_scratch.h"
#include "core/surface/projection/replace.h"
#include "core/surface/projection/swell.h"
#include "core/surface/projection/vertex_tiles.h"

namespace sinew {

// `replace` in tiles of 16, with replace() as reference and refuge.
// Docs/performance.md.

// `replace` of 16 vertices at once, by instruction set.

/// All that some of a frame's tiles need. The kernel allocates nothing.
struct ReplaceInputs {
  const VertexTiles* tiles = nullptr;
  std::span<const VertexTile> asked;  ///< Those of them that are moved.
  FieldView field;
  ReplaceSettings settings;
  FlatVertices flat;
  bool wraps = true;             ///< ImplicitWeights::wraps
  std::span<const float> omega;  ///< [V'] weights of the implicit surface.
  Surface* surface = nullptr;
  TileScratch* scratch = nullptr;
};

using ReplaceKernel = void (*)(ReplaceInputs& inputs);

/// The kernel for a set that this machine runs (instruction_set.h). All give the same bits.
[[nodiscard]] ReplaceKernel replaceKernel(InstructionSet set);

/// As replace() by newton, to 1e-6 H where roots are certain, and vertex by vertex where they are not. All
/// instruction sets and any number of threads give the same bits.
/// @param tiles  of the field's lists.  @param set  not kScalar; one that this machine runs.
void replaceInTiles(const ControlMesh& mesh, const FieldView& field, const ReplaceSettings& settings,
                    const FlatVertices& flat, const ImplicitWeights& weights, const VertexTiles& tiles,
                    InstructionSet set, Surface& surface, ProjectionScratch& scratch);

// A frame's tiles, shared out among threads.

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

// `swell` of 16 vertices at once, by instruction set.

/// All that some of a frame's tiles need. The kernel allocates nothing.
struct SwellInputs {
  const VertexTiles* tiles = nullptr;
  std::span<const VertexTile> asked;  ///< Those of them that are moved.
  FieldView field;
  SwellSettings settings;
  RiseView rise;
  Surface* surface = nullptr;
  TileScratch* scratch = nullptr;
};

using SwellKernel = void (*)(SwellInputs& inputs);

/// The kernel for a set that this machine runs (instruction_set.h); null for kScalar.
[[nodiscard]] SwellKernel swellKernel(InstructionSet set);

/// As swell() by newton, to 1e-6 H: 16 vertices at a time, and vertex by vertex where the first root is
/// not certain (TileScratch::uncertified). All instruction sets and any number of threads give the same bits, and a
/// vertex gets the same whatever lies beside it.
/// @param tiles  of the field's lists.  @param set  not kScalar; one that this machine runs.
void swellInTiles(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
                  const VertexTiles& tiles, InstructionSet set, Surface& surface, ProjectionScratch& scratch);

}  // namespace sinew
