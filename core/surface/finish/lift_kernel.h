// core/surface/finish/lift_kernel.h: how far edges are from following the heights, by instruction set.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/geometry/instruction_set.h"
#include "core/surface/finish/vertex_rings.h"

namespace sinew {

/// A vertex's place on the patch, and its height.
struct alignas(16) LiftPlace {
  std::array<float, 4> of{};
};

/// 1/length of the edges to six neighbors of a ring: those of 0, 2 and 4, 0, those of 1, 3 and 5, 0. It is 0 where
/// the length is 0 too.
struct alignas(32) SixEdges {
  static constexpr std::array<std::size_t, VertexRings::kMultiple> kAt{0, 4, 1, 5, 2, 6};  ///< Place of neighbor i.
  std::array<float, 8> perLength{};
};

/// Sums over a vertex's neighbors.
struct LiftSums {
  float difference = 0.0f;  ///< Sum of height differences per length.
  float perLength = 0.0f;
};

struct LiftInputs {
  const VertexRings* rings = nullptr;
  std::span<const int> lifted;
  const LiftPlace* places = nullptr;  ///< [V'] read at lifted vertices and their neighbors.
  SixEdges* edges = nullptr;          ///< Out: of the rings of all lifted vertices, in order.
  LiftSums* sums = nullptr;           ///< Out: [lifted]
};

using LiftKernel = void (*)(const LiftInputs& inputs);

/// All give the same bits.
[[nodiscard]] LiftKernel liftKernel(InstructionSet set);

struct SteepInputs {
  const VertexRings* rings = nullptr;
  std::span<const int> lifted;
  float slope = 0.0f;
  const LiftPlace* places = nullptr;  ///< [V'] read at lifted vertices, their neighbors and those across.
  int* steep = nullptr;  ///< Out: room for [lifted]; those whose height differs from one of these by more than the
                         ///< slope times the way, or by nearly that.
};

/// @return how many are too steep
using SteepKernel = std::size_t (*)(const SteepInputs& inputs);

/// All give the same bits.
[[nodiscard]] SteepKernel steepKernel(InstructionSet set);

}  // namespace sinew
