// core/surface/roots/root_lanes.h: the root inside each lane's bracket, by three methods. Included once per
// instruction set.
#if defined(SINEW_ROOT_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_ROOT_LANES_H
#undef SINEW_ROOT_LANES_H
#else
#define SINEW_ROOT_LANES_H
#endif

#include "core/surface/roots/quartic_lanes.h"
#include "core/surface/roots/ray_lanes.h"
#include "hwy/highway.h"
#include "sinew/rig/rig.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// How roots are found.
struct RootSettings {
  ProjectionKind method;
  float tolerance;  ///< World units.

  RootSettings(ProjectionKind kind, double worldTolerance)
      : method(kind), tolerance(static_cast<float>(worldTolerance)) {}

  /// A slope of psi less steep than this lets rounding move the root.
  [[nodiscard]] float minSlope() const { return 5e-8f / tolerance; }
};

/// What roots are: lanes whose root rounding cannot have moved.
struct LaneRoots {
  V t;
  M solved;
};

/// Newton's steps from `start`, kept inside the bracket.
inline LaneRoots newtonRoots(const RayLanes& rays, const LaneSearch& search, V start, const RootSettings& settings) {
  constexpr int kMaxSteps = 24;
  V low = search.low;
  V high = search.high;
  LaneRoots roots{start, none()};
  M open = search.bracketed;
  for (int step = 0; step < kMaxSteps && any(open); ++step) {
    const LaneSample at = rays.sample(roots.t);
    rays.count(open);
    const M above = hn::Gt(at.value, zero());
    low = select(above, roots.t, low);
    high = select(above, high, roots.t);
    const V newton = roots.t - at.value / at.slope;
    const M inside = both(hn::Ge(newton, low), hn::Le(newton, high));
    const V next = select(inside, newton, all(0.5f) * (low + high));
    const M still = hn::Le(hn::Abs(next - roots.t), all(settings.tolerance));
    const M done = both(open, still);
    roots.solved = hn::Or(roots.solved, both(done, hn::Le(at.slope, all(-settings.minSlope()))));
    roots.t = select(open, next, roots.t);
    open = andNot(open, done);
  }
  return roots;
}

/// Halvings, then one secant step (paper 4.2). A bracket here may be longer than one between breakpoints.
inline LaneRoots bisectedRoots(const RayLanes& rays, const LaneSearch& search, const RootSettings& settings) {
  constexpr int kHalvings = 10;
  V low = search.low;
  V high = search.high;
  V atLow = rays.sample(low).value;
  V atHigh = rays.sample(high).value;
  rays.count(search.bracketed);
  for (int i = 0; i < kHalvings; ++i) {
    const V middle = all(0.5f) * (low + high);
    const V value = rays.sample(middle).value;
    rays.count(search.bracketed);
    const M above = hn::Gt(value, zero());
    low = select(above, middle, low);
    atLow = select(above, value, atLow);
    high = select(above, high, middle);
    atHigh = select(above, atHigh, value);
  }
  const V secant = low + (high - low) * (atLow / (atLow - atHigh));
  const V t = select(both(hn::Ge(secant, low), hn::Le(secant, high)), secant, low);
  return {t, both(search.bracketed, hn::Le(rays.sample(t).slope, all(-settings.minSlope())))};
}

/// Closed form (paper 4.1). The bracket is first cut at places where some term begins or ends, until psi is one quartic
/// in it, or one a clique. The quartic's first root is where Newton's steps begin: they end at once unless another
/// clique wins before, and take out what single precision left. There is no closed form near shapes, whose r^2 is no
/// quadratic: from the bracket's beginning by Newton's steps alone.
inline LaneRoots closedFormRoots(const RayLanes& rays, LaneSearch search, const RootSettings& settings) {
  const RayQuartics quartics(rays);
  quartics.narrow(search);
  return newtonRoots(rays, search, quartics.firstRoot(search), settings);
}

HWY_INLINE LaneRoots solve(const RayLanes& rays, const LaneSearch& search, const RootSettings& settings) {
  switch (settings.method) {
    case ProjectionKind::kAnalytic:
      return closedFormRoots(rays, search, settings);
    case ProjectionKind::kBisection:
      return bisectedRoots(rays, search, settings);
    case ProjectionKind::kNewton:
      break;
  }
  return newtonRoots(rays, search, search.low, settings);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
