// core/surface/finish/fold_kernel.cpp: areas of four triangles at once, once per instruction set.
#include "core/surface/finish/fold.h"

#include <algorithm>

#include "core/geometry/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/finish/fold_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/geometry/lane_blocks.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

using Pair = Blocks<2>;

/// Products whose sums are the squared face of the patch, and its dot product with the surface's.
HWY_INLINE Pair facesOf(const VertexPair* vertices, const std::array<int, 3>& t) {
  const Pair a = Pair::load(vertices[t[0]].of.data());
  const Pair ab = Pair::load(vertices[t[1]].of.data()) - a;
  const Pair ac = Pair::load(vertices[t[2]].of.data()) - a;
  const Pair face = yzxw(ab * yzxw(ac) - yzxw(ab) * ac);
  return face * bothOf(lower(face), lower(face));
}

std::size_t findShrunk(const ShrunkSearch& search) {
  constexpr std::size_t kTogether = 4;
  const Blocks<1> least = Blocks<1>::all(search.least);
  const std::size_t asked = search.asked.size();
  std::size_t count = 0;
  for (std::size_t begin = 0; begin < asked; begin += kTogether) {
    // The last triangle is repeated, but counted once.
    const auto index = [&](std::size_t i) HWY_ATTR { return search.asked[std::min(begin + i, asked - 1)]; };
    const auto faces = [&](std::size_t i) HWY_ATTR { return facesOf(search.vertices, search.triangles[index(i)]); };
    const Pair both = sums(faces(0), faces(1), faces(2), faces(3));
    alignas(16) std::array<float, kTogether> lack;
    (least * lower(both) - upper(both)).store(lack.data());
    for (std::size_t i = 0; i < kTogether; ++i) {
      search.shrunk[count] = index(i);
      count += lack[i] > 0.0f && begin + i < asked ? 1 : 0;
    }
  }
  return count;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {

FoldKernel foldKernel(InstructionSet set) { SINEW_RETURN_BY_SET(set, findShrunk) }

}  // namespace sinew
#endif
