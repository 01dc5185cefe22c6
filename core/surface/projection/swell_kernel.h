// core/surface/projection/swell_kernel.h: `swell` of 16 vertices at once, by instruction set.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/instruction_set.h"
#include "core/surface/projection/projection_scratch.h"
#include "core/surface/projection/swell.h"
#include "core/surface/projection/vertex_tiles.h"

namespace sinew {

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

}  // namespace sinew
