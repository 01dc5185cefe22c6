// core/surface/roots/root_lanes.h: the roots in many rays' brackets. Included once per instruction set.
#if defined(SINEW_ROOT_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_ROOT_LANES_H
#undef SINEW_ROOT_LANES_H
#else
#define SINEW_ROOT_LANES_H
#endif

#include "core/surface/roots/ray_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

struct LaneRoots {
  V t;
  M solved;  ///< Lanes whose root rounding cannot have moved.
};

/// Newton steps from the start of each lane's bracket, kept inside it. @param tolerance  world units.
inline LaneRoots rootsIn(const RayLanes& rays, const LaneSearch& search, float tolerance) {
  constexpr int kMaxSteps = 24;
  const float minSlope = 5e-8f / tolerance;  // If psi falls more slowly, rounding can move the root.
  V low = search.low;
  V high = search.high;
  LaneRoots roots{search.low, none()};
  M open = search.bracketed;
  for (int step = 0; step < kMaxSteps && any(open); ++step) {
    const Sample at = rays.sample(roots.t);
    const M above = hn::Gt(at.value, zero());
    low = select(above, roots.t, low);
    high = select(above, high, roots.t);
    const V newton = roots.t - at.value / at.slope;
    const M inside = both(hn::Ge(newton, low), hn::Le(newton, high));
    const V next = select(inside, newton, all(0.5f) * (low + high));
    const M still = hn::Le(hn::Abs(next - roots.t), all(tolerance));
    const M done = both(open, still);
    roots.solved = hn::Or(roots.solved, both(done, hn::Le(at.slope, all(-minSlope))));
    roots.t = select(open, next, roots.t);
    open = andNot(open, done);
  }
  return roots;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
