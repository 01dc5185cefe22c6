// core/surface/projection/replace_kernel.h: `replace` of 16 vertices at once, by instruction set.
#pragma once

#include <span>

#include "core/geometry/instruction_set.h"
#include "core/surface/projection/projection_scratch.h"
#include "core/surface/projection/replace.h"
#include "core/surface/projection/vertex_tiles.h"

namespace sinew {

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

}  // namespace sinew
