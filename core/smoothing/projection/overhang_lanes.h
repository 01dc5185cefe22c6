// core/smoothing/projection/overhang_lanes.h: overhang.h in lanes. Included once per instruction set.
#if defined(SINEW_OVERHANG_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_OVERHANG_LANES_H
#undef SINEW_OVERHANG_LANES_H
#else
#define SINEW_OVERHANG_LANES_H
#endif

#include "core/smoothing/projection/overhang.h"
#include "core/smoothing/roots/ray_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// A part of the way, and the slopes of sigma s + psi(s) at its ends.
struct LanePart {
  V low;
  V high;
  V falls;
  V rises;
};

/// The least of s + psi(s) / sigma inside a part in which it falls, then rises. @param height  in and out
HWY_INLINE void lowerInside(const RayLanes& rays, V sigma, LanePart part, M dips, V& height) {
  for (int k = 0; k < Overhang::kNarrowings && any(dips); ++k) {
    const V lowest = part.low - part.falls * (part.high - part.low) / (part.rises - part.falls);
    const LaneSample at = rays.sample(lowest);
    rays.count(dips);
    height = select(dips, hn::Min(height, lowest + at.value / sigma), height);
    const V slope = at.slope + sigma;
    const M fallsOn = hn::Lt(slope, zero());
    part.low = select(fallsOn, lowest, part.low);
    part.falls = select(fallsOn, slope, part.falls);
    part.high = select(fallsOn, part.high, lowest);
    part.rises = select(fallsOn, part.rises, slope);
    dips = both(dips, both(hn::Lt(part.falls, zero()), hn::Gt(part.rises, zero())));
  }
}

/// heightBelowOverhangs(). @param t  roots.  @param asked  lanes; others keep t.
HWY_NOINLINE inline V heightBelowOverhangs(const RayLanes& rays, V t, V sigma, V part, M asked) {
  LaneSample from = rays.sample(zero());
  rays.count(asked);
  V height = select(asked, hn::Min(t, from.value / sigma), t);
  for (int i = 0; i < Overhang::kMostParts; ++i) {
    const V low = all(static_cast<float>(i)) * part;
    asked = both(asked, hn::Lt(low, t));
    if (!any(asked)) break;
    const V high = hn::Min(all(static_cast<float>(i + 1)) * part, t);
    const LaneSample to = rays.sample(high);
    rays.count(asked);
    height = select(both(asked, hn::Lt(high, t)), hn::Min(height, high + to.value / sigma), height);
    const LanePart here{low, high, from.slope + sigma, to.slope + sigma};
    lowerInside(rays, sigma, here, both(asked, both(hn::Lt(here.falls, zero()), hn::Gt(here.rises, zero()))), height);
    from = to;
  }
  return hn::Max(height, zero());
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
