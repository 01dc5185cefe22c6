// core/surface/projection/overhang_lanes.h: overhang.h in lanes. Included once per instruction set.
#if defined(SINEW_OVERHANG_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_OVERHANG_LANES_H
#undef SINEW_OVERHANG_LANES_H
#else
#define SINEW_OVERHANG_LANES_H
#endif

#include "core/surface/projection/overhang.h"
#include "core/surface/roots/ray_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

using LaneEnd = PartEnd<V>;

/// s + psi(s) / sigma along the rays.
struct SlowFall {
  const RayLanes& rays;
  V inverseSigma;

  HWY_INLINE LaneEnd endAt(V s) const {
    const LaneSample here = rays.sample(s);
    return {s, s + here.value * inverseSigma, all(1.0f) + here.slope * inverseSigma};
  }
};

/// lowestBetween().
HWY_INLINE V lowestBetween(const LaneEnd& low, const LaneEnd& high, int step) {
  const V length = high.at - low.at;
  if (step % 2 != 0 && step + 1 < Overhang::kNarrowings) return low.at + all(0.5f) * length;
  const V turns = high.slope - low.slope;
  const V to =
      step % 2 == 0 ? (high.slope * length + (low.sum - high.sum)) / turns : zero() - low.slope * length / turns;
  return low.at + hn::Min(hn::Max(zero(), to), length);
}

HWY_INLINE LaneEnd select(M mask, const LaneEnd& yes, const LaneEnd& no) {
  return {select(mask, yes.at, no.at), select(mask, yes.sum, no.sum), select(mask, yes.slope, no.slope)};
}

/// The least of s + psi(s) / sigma inside a part at whose ends it falls and rises. @param height  in and out
HWY_INLINE void lowerInside(const SlowFall& fall, LaneEnd low, LaneEnd high, M asked, V& height) {
  const auto dips = [&]() HWY_ATTR { return both(asked, both(hn::Lt(low.slope, zero()), hn::Gt(high.slope, zero()))); };
  asked = dips();
  for (int k = 0; k < Overhang::kNarrowings && any(asked); ++k) {
    const LaneEnd inside = fall.endAt(lowestBetween(low, high, k));
    height = select(asked, hn::Min(height, inside.sum), height);
    const M fallsOn = hn::Lt(inside.slope, zero());
    low = select(fallsOn, inside, low);
    high = select(fallsOn, high, inside);
    asked = dips();
  }
}

/// heightBelowOverhangs(). @param t  roots.  @param asked  lanes; others keep t.
HWY_NOINLINE inline V heightBelowOverhangs(const RayLanes& rays, V t, V sigma, V part, M asked) {
  const SlowFall fall{rays, all(1.0f) / sigma};
  LaneEnd from = fall.endAt(zero());
  V height = select(asked, hn::Min(t, from.sum), t);
  for (int i = 0; i < Overhang::kMostParts; ++i) {
    asked = both(asked, hn::Lt(all(static_cast<float>(i)) * part, t));
    if (!any(asked)) break;
    const LaneEnd to = fall.endAt(hn::Min(all(static_cast<float>(i + 1)) * part, t));
    height = select(both(asked, hn::Lt(to.at, t)), hn::Min(height, to.sum), height);
    lowerInside(fall, from, to, asked, height);
    from = to;
  }
  return hn::Max(height, zero());
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
