// core/surface/finish/lift_kernel.cpp: six neighbors at once, once per instruction set.
#include "core/surface/finish/lifted_heights.h"

#include "core/geometry/at.h"
#include "core/geometry/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/finish/lift_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/geometry/lane_blocks.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

using Pair = Blocks<2>;

/// Places and heights of two vertices relative to `own`.
HWY_INLINE Pair twoSeen(const LiftPlace* places, const int* two, const Pair& own) {
  return Pair::join(at(places, two[0]).of.data(), at(places, two[1]).of.data()) - own;
}

void sumEdges(const LiftInputs& inputs) {
  const Pair zero = Pair::all(0.0f);
  const Pair one = Pair::all(1.0f);
  SixEdges* edges = inputs.edges;
  LiftSums* out = inputs.sums;
  for (const int vertex : inputs.lifted) {
    const float* place = at(inputs.places, vertex).of.data();
    const Pair own = Pair::join(place, place);
    Pair lengths = zero;
    Pair differences = zero;
    const std::span<const int> ring = inputs.rings->at(vertex);
    for (std::size_t i = 0; i < ring.size(); i += VertexRings::kMultiple) {
      const Pair a = twoSeen(inputs.places, &ring[i], own);
      const Pair b = twoSeen(inputs.places, &ring[i + 2], own);
      const Pair c = twoSeen(inputs.places, &ring[i + 4], own);
      const Pair squared = sums(xyzAndW(a * a, zero), xyzAndW(b * b, zero), xyzAndW(c * c, zero), zero);
      const Pair heights = sums(xyzAndW(zero, a), xyzAndW(zero, b), xyzAndW(zero, c), zero);
      const Pair perLength = wherePositive(squared, one / root(squared));
      perLength.store(edges++->perLength.data());
      lengths = lengths + perLength;
      differences = differences + perLength * heights;
    }
    const Blocks<1> both =
        sums(lower(differences) + upper(differences), lower(lengths) + upper(lengths), lower(zero), lower(zero));
    *out++ = {first(both), first(spread<1>(both))};
  }
}

/// Compares squares: a height is steep if its square exceeds that of the slope times the distance, or nearly so.
std::size_t findSteep(const SteepInputs& inputs) {
  constexpr float kNearly = 0.9999f;
  const float squaredSlope = kNearly * inputs.slope * inputs.slope;
  const Pair zero = Pair::all(0.0f);
  const Pair weights = xyzAndW(Pair::all(-squaredSlope), Pair::all(1.0f));
  int* out = inputs.steep;
  for (const int vertex : inputs.lifted) {
    const float* place = at(inputs.places, vertex).of.data();
    const Pair own = Pair::join(place, place);
    Pair steep = zero;
    for (const std::span<const int> ring : {inputs.rings->at(vertex), inputs.rings->acrossFrom(vertex)}) {
      for (std::size_t i = 0; i < ring.size(); i += VertexRings::kMultiple) {
        const Pair a = twoSeen(inputs.places, &ring[i], own);
        const Pair b = twoSeen(inputs.places, &ring[i + 2], own);
        const Pair c = twoSeen(inputs.places, &ring[i + 4], own);
        steep = max(steep, sums(weights * a * a, weights * b * b, weights * c * c, zero));
      }
    }
    const Blocks<1> steepest = max(lower(steep), upper(steep));
    const Blocks<1> most = max(steepest, max(yzxw(steepest), zxyw(steepest)));  // The fourth is 0.
    *out = vertex;
    out += first(most) > 0.0f ? 1 : 0;
  }
  return static_cast<std::size_t>(out - inputs.steep);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {

LiftKernel liftKernel(InstructionSet set){SINEW_RETURN_BY_SET(set, sumEdges)}

SteepKernel steepKernel(InstructionSet set) {
  SINEW_RETURN_BY_SET(set, findSteep)
}

}  // namespace sinew
#endif
