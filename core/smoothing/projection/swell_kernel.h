// core/smoothing/projection/swell_kernel.h: `swell` of 16 vertices at once, by instruction set.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/lanes/instruction_set.h"
#include "core/smoothing/projection/carrier_walk.h"
#include "core/smoothing/projection/swell.h"
#include "core/smoothing/projection/swell_tiles.h"
#include "core/smoothing/roots/lane_terms.h"

namespace sinew {

/// Counts of one frame.
struct KernelCounts {
  int projected = 0;
  float residualMax = 0.0f;
};

/// All that a frame's tiles need. Nothing here is allocated by the kernel.
struct SwellFrame {
  const SwellTiles* tiles = nullptr;
  FieldView field;
  SwellSettings settings;
  RiseView rise;
  Surface* surface = nullptr;
  LaneScratch* lanes = nullptr;
  std::vector<int>* near = nullptr;  ///< Has room for the tile with the most candidates.
  std::vector<carrier_walk::Span>* spans = nullptr;
  std::vector<int>* uncertified = nullptr;  ///< Vertices whose first root the kernel cannot vouch for; as many fit.
  std::vector<int>* shaped = nullptr;       ///< Vertices near a primitive that is no ellipsoid; as many fit.
  KernelCounts counts;
};

using SwellKernel = void (*)(SwellFrame& frame);

/// The kernel for a set that this machine runs (instruction_set.h); null for kScalar.
[[nodiscard]] SwellKernel swellKernel(InstructionSet set);

}  // namespace sinew
