// core/surface/projection/tile_projection.h: `swell` and `replace` in tiles of 16 vertices. swell() and replace() are
// their references, and project the vertices whose first root is not certain. docs/performance.md.
#pragma once

#include <span>

#include "core/geometry/instruction_set.h"
#include "core/surface/projection/projection_scratch.h"
#include "core/surface/projection/replace.h"
#include "core/surface/projection/swell.h"
#include "core/surface/projection/vertex_tiles.h"

namespace sinew {

/// Moves vertices as swell() does by newton, to 1e-6 H. All instruction sets and any number of threads give the same
/// bits, and no vertex depends on what lies beside it.  @param tiles  of the field's lists.
void swellInTiles(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
                  const VertexTiles& tiles, Surface& surface, ProjectionScratch& scratch);

/// Moves vertices as replace() does by newton; the rest as above.
void replaceInTiles(const ControlMesh& mesh, const FieldView& field, const ReplaceSettings& settings,
                    const FlatVertices& flat, const ImplicitWeights& weights, const VertexTiles& tiles,
                    Surface& surface, ProjectionScratch& scratch);

// Kernels for a range of a frame's tiles. They allocate nothing, and all sets give the same bits.

struct SwellInputs {
  const VertexTiles* tiles = nullptr;
  std::span<const VertexTile> asked;  ///< Tiles of the range.
  FieldView field;
  SwellSettings settings;
  RiseView rise;
  Surface* surface = nullptr;
  TileScratch* scratch = nullptr;
};

struct ReplaceInputs {
  const VertexTiles* tiles = nullptr;
  std::span<const VertexTile> asked;  ///< Tiles of the range.
  FieldView field;
  ReplaceSettings settings;
  FlatVertices flat;
  bool wraps = true;             ///< ImplicitWeights::wraps
  std::span<const float> omega;  ///< [V'] weights of the implicit surface.
  Surface* surface = nullptr;
  TileScratch* scratch = nullptr;
};

using SwellKernel = void (*)(SwellInputs& inputs);
using ReplaceKernel = void (*)(ReplaceInputs& inputs);

[[nodiscard]] SwellKernel swellKernel(InstructionSet set);  ///< @param set  not kScalar; one that this machine runs.
[[nodiscard]] ReplaceKernel replaceKernel(InstructionSet set);

}  // namespace sinew
