// core/surface/finish/fold_kernel.h: the triangles whose area has shrunk, by instruction set.
#pragma once

#include <array>
#include <span>

#include "core/geometry/instruction_set.h"
#include "core/surface/finish/vertex_pairs.h"

namespace sinew {

struct ShrunkSearch {
  std::span<const int> asked;                     ///< Refined triangles.
  const std::array<int, 3>* triangles = nullptr;  ///< [T n^2] their corners.
  const VertexPair* vertices = nullptr;           ///< [V'] read at those.
  float least = 0.0f;                             ///< Area over the patch's, signed along it (q of fold.h).
  int* shrunk = nullptr;                          ///< Out: those with q < least, in order; room for all and 4 more.
};

/// Returns how many have shrunk.
using FoldKernel = std::size_t (*)(const ShrunkSearch& search);

/// All give the same bits.
[[nodiscard]] FoldKernel foldKernel(InstructionSet set);

}  // namespace sinew
