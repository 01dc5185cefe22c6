// core/smoothing/roots/ray_lanes.h: first roots of many rays at once. Included once per instruction set.
// docs/performance.md proves what is claimed here.
#if defined(SINEW_RAY_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_RAY_LANES_H
#undef SINEW_RAY_LANES_H
#else
#define SINEW_RAY_LANES_H
#endif

#include <cstdint>
#include <span>

#include "core/lanes/lane_points.h"
#include "core/smoothing/roots/lane_terms.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// The skin's own field less T, times the direction's sign: falls from 0 at t = 0.
struct LaneSkin {
  V sign;          ///< 1: outwards, -1: inwards.
  V inverseWidth;  ///< 1 / W
  V isoRadius;     ///< r_T
  V isoRoot;       ///< sqrt T
  V most;          ///< Of the fall below sqrt T: outwards the field ends.
  V offset;        ///< Added everywhere: 0, or all there is in `replace`, which has no field of the skin.

  // w^2 - T = (w - sqrt T)(w + sqrt T): exact in the last place where t, and so the rise, is tiny.
  HWY_INLINE V fall(V t) const {
    const V u = t * inverseWidth;
    return hn::Min(u * (isoRadius + isoRadius + sign * u), most);
  }
  HWY_INLINE V value(V t) const {
    const V e = fall(t);
    return offset - e * (isoRoot + isoRoot - sign * e);
  }
  HWY_INLINE V radius(V t) const { return hn::Max(zero(), isoRadius + sign * (t * inverseWidth)); }
  HWY_INLINE V root(V t) const { return isoRoot - sign * fall(t); }
  HWY_INLINE V slope(V t) const { return all(-4.0f) * inverseWidth * (radius(t) * root(t)); }
};

/// psi(t) = sign (skin(t) + F(t) - T) and its slope.
struct LaneSample {
  V value;
  V slope;
};

/// What holds on a whole stretch of every ray.
struct LaneBounds {
  V least;     ///< psi is nowhere less ...
  V steepest;  ///< ... and its slope nowhere more.
  V values;    ///< Sums of the magnitudes that went into the two: what rounding is measured by.
  V slopes;
  V atEnd;  ///< psi at the stretch's end.
};

/// How far the search of every ray has come.
struct LaneSearch {
  V low;   ///< psi > 0 up to here, ...
  V high;  ///< ... and a root lies before this, in a stretch where psi only falls: of the bracketed.
  M bracketed;
  M rootless;  ///< psi > 0 up to the end.
};

/// Where along each ray psi might rise.
struct LaneRise {
  V from;  ///< Before this psi falls ...
  V to;    ///< ... and after this again.
  V end;   ///< Of the search.
};

/// Whether a ray may meet a ball; rounding never says no where it does.
/// @param fromCenter  the ray's origin less the ball's centre.  @param d  unit.
HWY_INLINE M mayMeet(const V3& fromCenter, const V3& d, float radius) {
  const V squared = dot(fromCenter, fromCenter);
  const V along = dot(fromCenter, d);
  const V within = all(1.01f * radius * radius) + all(1e-5f) * squared;
  const M ahead = hn::Or(hn::Lt(along, zero()), hn::Lt(squared, within));
  return both(ahead, hn::Lt(squared - along * along, within));
}

/// Whether a term is above 0 anywhere at t >= 0: at its middle, or at 0 by sample()'s own operations.
HWY_INLINE M liesAhead(V a, V middle, V peak) {
  const V atStart = peak - a * middle * middle;
  return both(hn::Gt(peak, zero()), hn::Or(hn::Gt(middle, zero()), hn::Gt(atStart, zero())));
}

/// psi along the rays of the lanes from `first` on.
class RayLanes {
 public:
  RayLanes(LaneScratch& scratch, const LaneCliques& cliques, const LaneSkin& skin, std::size_t first)
      : scratch_(scratch), cliques_(cliques), skin_(skin), first_(first) {}

  HWY_INLINE std::span<const LaneTerm> terms() const { return {scratch_.terms.data(), scratch_.termCount}; }

  LaneSample sample(V t) const {
    V value = zero();
    V slope = zero();
    clearSums();
    for (const LaneTerm& term : terms()) {
      const V d = t - load(term.middle);
      const V ad = load(term.a) * d;
      const V w = hn::Max(zero(), load(term.peak) - ad * d);
      const V fw = load(term.factor) * w;
      if (cliques_.empty() || term.slot == LaneTerm::kEverySum) {
        value = value + fw * w;
        slope = slope + fw * ad;
      } else {
        add(term.slot, 0, fw * w);
        add(term.slot, 1, fw * ad);
      }
    }
    addWinner(value, slope);
    return {skin_.value(t) + value, skin_.slope(t) - all(4.0f) * slope};
  }

  /// On [t0, t1], by lane. w is concave: its least value is at an end, its largest at an end or at its peak.
  LaneBounds bounds(V t0, V t1) const {
    V least = zero();
    V atEnd = zero();
    V steepest = zero();
    V values = zero();
    V slopes = zero();
    clearSums();
    for (const LaneTerm& term : terms()) {
      const V a = load(term.a);
      const V factor = load(term.factor);
      const V peak = load(term.peak);
      const V d0 = t0 - load(term.middle);
      const V d1 = t1 - load(term.middle);
      const V w0 = hn::Max(zero(), peak - a * d0 * d0);
      const V w1 = hn::Max(zero(), peak - a * d1 * d1);
      const V low = hn::Min(w0, w1);
      const M peaks = both(hn::Lt(d0, zero()), hn::Gt(d1, zero()));
      const V high = choose(peaks, hn::Max(zero(), peak), hn::Max(w0, w1));
      const M adds = hn::Ge(factor, zero());
      const V w = choose(adds, low, high);
      const V f = factor * w * w;
      // The slope is -4 factor a d w: the least of d w where the term adds, the largest where it takes away.
      const V leastDw = hn::Min(d0, zero()) * high + hn::Max(d0, zero()) * low;
      const V mostDw = hn::Max(d1, zero()) * high + hn::Min(d1, zero()) * low;
      const V dw = factor * a * choose(adds, leastDw, mostDw);
      values = values + hn::Abs(f);
      slopes = slopes + hn::Abs(dw);
      const V end = factor * w1 * w1;
      if (cliques_.empty() || term.slot == LaneTerm::kEverySum) {
        least = least + f;
        atEnd = atEnd + end;
        steepest = steepest - dw;
      } else {
        add(term.slot, 0, f);
        add(term.slot, 1, end);
        add(term.slot, 2, zero() - dw);
      }
    }
    addWinners(least, atEnd, steepest);
    const V skin = skin_.value(t1);
    // The factors of the skin's slope rise or fall all along: their least values are at the ends.
    const V falls =
        skin_.inverseWidth * hn::Min(skin_.radius(t0), skin_.radius(t1)) * hn::Min(skin_.root(t0), skin_.root(t1));
    return {skin + least, all(4.0f) * (steepest - falls), values + hn::Abs(skin), all(4.0f) * (slopes + falls),
            skin + atEnd};
  }

  /// Brackets the first change of sign of the active lanes; psi > 0 at 0. Lanes that end up neither bracketed nor
  /// rootless have no certificate. Each lane goes its own way: none sees what its neighbours are.
  LaneSearch bracket(const LaneRise& rise, M active) const {
    const M outward = hn::Gt(skin_.sign, zero());
    const M falls = hn::Ge(rise.from, rise.end);
    const V first = hn::Min(rise.from, rise.end);
    LaneSearch search{zero(), first, both(both(active, falls), outward), none()};
    M open = butNot(active, search.bracketed);
    if (!any(open)) return search;
    const V value = sample(first).value;
    count(open);
    const M below = both(open, hn::Le(value, zero()));
    const M above = both(open, hn::Gt(value, zero()));
    search.bracketed = hn::Or(search.bracketed, below);
    search.rootless = both(above, falls);
    march(rise, butNot(above, falls), search);
    return search;
  }

  /// The root inside the bracket, by Newton steps kept inside it. Returns the lanes that have converged on a slope
  /// at least `leastSlope` steep: elsewhere rounding would move the root.
  M solve(const LaneSearch& search, float tolerance, float leastSlope, V& t) const {
    constexpr int kMostSteps = 24;
    V low = search.low;
    V high = search.high;
    t = low;
    M open = search.bracketed;
    M solved = none();
    for (int step = 0; step < kMostSteps && any(open); ++step) {
      const LaneSample at = sample(t);
      count(open);
      const M above = hn::Gt(at.value, zero());
      low = choose(above, t, low);
      high = choose(above, high, t);
      const V newton = t - at.value / at.slope;
      const M inside = both(hn::Ge(newton, low), hn::Le(newton, high));
      const V next = choose(inside, newton, all(0.5f) * (low + high));
      const M still = hn::Le(hn::Abs(next - t), all(tolerance));
      const M done = both(open, still);
      solved = hn::Or(solved, both(done, hn::Le(at.slope, all(-leastSlope))));
      t = choose(open, next, t);
      open = butNot(open, done);
    }
    return solved;
  }

  HWY_INLINE V load(const LaneFloats& floats) const { return hn::Load(kTag, floats.at(first_)); }
  HWY_INLINE void store(V value, LaneFloats& floats) const { hn::Store(value, kTag, floats.at(first_)); }

 protected:
  /// From `low`, stretch after stretch: one is passed if its bounds prove that psi stays positive, and holds the root
  /// if psi proves to fall through 0 in it; else it is halved.
  void march(const LaneRise& rise, M open, LaneSearch& search) const {
    constexpr int kMostStretches = 20;
    const M outward = hn::Gt(skin_.sign, zero());
    const V from = hn::Min(rise.from, rise.end);
    const V to = hn::Min(rise.to, rise.end);
    V low = choose(open, from, search.low);
    V high = choose(open, to, search.high);
    for (int i = 0; i < kMostStretches && any(open); ++i) {
      const LaneBounds seen = bounds(low, high);
      count(open);
      const M clear = hn::Gt(seen.least, all(1e-5f) * seen.values);
      const M falls = hn::Le(seen.steepest, all(-1e-3f) * seen.slopes);
      const M found = both(both(open, falls), hn::Le(seen.atEnd, zero()));
      const M passed = both(open, hn::Or(clear, both(falls, hn::Gt(seen.atEnd, zero()))));
      search.bracketed = hn::Or(search.bracketed, found);
      open = butNot(open, found);
      const V length = high - low;
      low = choose(passed, high, low);
      const M over = both(passed, hn::Ge(low, to));
      const M ended = both(over, hn::Ge(low, rise.end));
      const M lastFall = butNot(over, ended);
      search.rootless = hn::Or(search.rootless, ended);
      const V onward = choose(hn::Lt(low, to), hn::Min(low + length + length, to), rise.end);
      const V halved = low + all(0.5f) * length;
      high = choose(open, choose(passed, onward, halved), high);
      // Outwards only -T is left at the end.
      const M certain = both(lastFall, outward);
      search.bracketed = hn::Or(search.bracketed, certain);
      open = butNot(open, hn::Or(ended, certain));
    }
    search.low = low;
    search.high = high;
  }

  void clearSums() const {
    if (cliques_.empty()) return;
    for (std::size_t slot = 0; slot < cliques_.slotCount; ++slot) {
      for (LaneFloats& sum : scratch_.sums[slot].of) store(zero(), sum);
    }
  }

  HWY_INLINE void add(int slot, std::size_t which, V value) const {
    LaneFloats& sum = scratch_.sums[static_cast<std::size_t>(slot)].of[which];
    store(load(sum) + value, sum);
  }

  HWY_INLINE V sumOf(std::size_t clique, std::size_t which) const {
    V sum = zero();
    for (int i = cliques_.begin[clique]; i < cliques_.begin[clique + 1]; ++i) {
      const int slot = cliques_.slots[static_cast<std::size_t>(i)];
      sum = sum + load(scratch_.sums[static_cast<std::size_t>(slot)].of[which]);
    }
    return sum;
  }

  /// Of the cliques' sums the one whose F is largest; psi's sign turns it into the least.
  void addWinner(V& value, V& slope) const {
    if (cliques_.empty()) return;
    V best = zero();
    V bestSlope = zero();
    for (std::size_t k = 0; k + 1 < cliques_.begin.size(); ++k) {
      const V sum = sumOf(k, 0);
      const M wins = hn::Gt(skin_.sign * sum, skin_.sign * best);
      best = choose(wins, sum, best);
      bestSlope = choose(wins, sumOf(k, 1), bestSlope);
    }
    value = value + best;
    slope = slope + bestSlope;
  }

  void addWinners(V& least, V& atEnd, V& steepest) const {
    if (cliques_.empty()) return;
    V bestLeast = zero();
    V bestAtEnd = zero();
    V bestSteepest = zero();
    for (std::size_t k = 0; k + 1 < cliques_.begin.size(); ++k) {
      const V low = sumOf(k, 0);
      const V end = sumOf(k, 1);
      bestLeast = choose(hn::Gt(skin_.sign * low, skin_.sign * bestLeast), low, bestLeast);
      bestAtEnd = choose(hn::Gt(skin_.sign * end, skin_.sign * bestAtEnd), end, bestAtEnd);
      bestSteepest = hn::Max(bestSteepest, sumOf(k, 2));
    }
    least = least + bestLeast;
    atEnd = atEnd + bestAtEnd;
    steepest = steepest + bestSteepest;
  }

  void count(M lanes) const { scratch_.evaluations += static_cast<std::int64_t>(hn::CountTrue(kTag, lanes)); }

  LaneScratch& scratch_;
  const LaneCliques& cliques_;
  const LaneSkin& skin_;
  std::size_t first_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
