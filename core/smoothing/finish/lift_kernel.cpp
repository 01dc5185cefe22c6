// core/smoothing/finish/lift_kernel.cpp: six neighbors at once, compiled once per instruction set.
#include "core/smoothing/finish/lift_kernel.h"

#include "core/lanes/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/smoothing/finish/lift_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/lanes/lane_blocks.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

using Pair = Blocks<2>;

void sumEdges(const LiftInputs& inputs) {
  const Pair zero = Pair::all(0.0f);
  const Pair one = Pair::all(1.0f);
  const Pair slope = Pair::all(inputs.slope);
  SixEdges* edges = inputs.edges;
  LiftSums* out = inputs.sums;
  for (const int vertex : inputs.moved) {
    const auto place = [&](int v) HWY_ATTR { return inputs.places[v].of.data(); };
    const Pair own = Pair::join(place(vertex), place(vertex));
    Pair lengths = zero;
    Pair differences = zero;
    Pair steep = zero;
    const std::span<const int> ring = inputs.rings->at(vertex);
    for (std::size_t i = 0; i < ring.size(); i += VertexRings::kMultiple) {
      const auto two = [&](std::size_t k)
                           HWY_ATTR { return Pair::join(place(ring[i + k]), place(ring[i + k + 1])) - own; };
      const Pair a = two(0);
      const Pair b = two(2);
      const Pair c = two(4);
      const Pair squared = sums(xyzAndW(a * a, zero), xyzAndW(b * b, zero), xyzAndW(c * c, zero), zero);
      const Pair heights = sums(xyzAndW(zero, a), xyzAndW(zero, b), xyzAndW(zero, c), zero);
      const Pair length = root(squared);
      const Pair perLength = wherePositive(squared, one / length);
      steep = max(steep, magnitude(heights) - slope * length);
      perLength.store(edges++->perLength.data());
      lengths = lengths + perLength;
      differences = differences + perLength * heights;
    }
    const Blocks<1> both =
        sums(lower(differences) + upper(differences), lower(lengths) + upper(lengths), lower(zero), lower(zero));
    const Blocks<1> steepest = max(lower(steep), upper(steep));
    const Blocks<1> most = max(steepest, max(yzxw(steepest), zxyw(steepest)));  // The fourth is 0.
    *out++ = {first(both), first(spread<1>(both)), first(most)};
  }
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "core/lanes/dispatch.h"

namespace sinew {

LiftKernel liftKernel(InstructionSet set) { SINEW_RETURN_BY_SET(set, sumEdges) }

}  // namespace sinew
#endif
