// core/smoothing/roots/change_lanes.h: first changes of sign along many rays that have no skin of their own. Included
// once per instruction set. docs/performance.md proves what is claimed here.
#if defined(SINEW_CHANGE_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_CHANGE_LANES_H
#undef SINEW_CHANGE_LANES_H
#else
#define SINEW_CHANGE_LANES_H
#endif

#include <limits>

#include "core/smoothing/roots/ray_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// psi = sign (F - T), which may rise and fall anywhere.
class ChangeLanes : public RayLanes {
 public:
  using RayLanes::RayLanes;

  /// The first change of sign between `begin` and `end`: stretch after stretch, each passed if its bounds prove that
  /// psi stays positive, and holding the root if psi proves to fall through 0 in it; else halved. A lane whose psi is
  /// not above 0 at `begin` has its root there.
  LaneSearch first(V begin, V end, M active) const {
    constexpr int kMostStretches = 40;
    LaneSearch search{begin, end, none(), butNot(active, hn::Lt(begin, end))};
    M open = butNot(active, search.rootless);
    if (!any(open)) return search;
    const M atBegin = both(open, hn::Le(sample(begin).value, zero()));
    count(open);
    search.bracketed = atBegin;
    open = butNot(open, atBegin);
    V low = begin;
    V high = choose(atBegin, begin, end);
    for (int i = 0; i < kMostStretches && any(open); ++i) {
      const Stretch seen = boundsOf(low, high);
      count(open);
      const V enough = all(1e-3f) * seen.slopes;
      const M clear = hn::Gt(seen.least, all(1e-5f) * seen.values);
      const M rises = hn::Ge(seen.gentlest, enough);
      const M falls = hn::Le(seen.steepest, zero() - enough);
      const M found = both(both(open, falls), hn::Le(seen.atEnd, zero()));
      const M passed = both(open, hn::Or(hn::Or(clear, rises), both(falls, hn::Gt(seen.atEnd, zero()))));
      search.bracketed = hn::Or(search.bracketed, found);
      open = butNot(open, found);
      const V length = high - low;
      const V halved = low + all(0.5f) * length;
      low = choose(passed, high, low);
      high = choose(open, choose(passed, hn::Min(high + length + length, end), halved), high);
      const M over = both(passed, hn::Ge(low, end));
      search.rootless = hn::Or(search.rootless, over);
      open = butNot(open, over);
    }
    search.low = low;
    search.high = high;
    return search;
  }

 private:
  /// What holds on a whole stretch; see LaneBounds.
  struct Stretch {
    V least;
    V steepest;
    V gentlest;  ///< psi's slope is nowhere less.
    V values;
    V slopes;
    V atEnd;
  };

  static constexpr std::size_t kLeast = 0;
  static constexpr std::size_t kAtEnd = 1;
  static constexpr std::size_t kSteepest = 2;
  static constexpr std::size_t kGentlest = 3;
  static constexpr std::size_t kMost = 4;

  /// On [t0, t1], by lane. w is concave: its least value is at an end, its largest at an end or at its peak.
  Stretch boundsOf(V t0, V t1) const {
    Stretch sum{zero(), zero(), zero(), zero(), zero(), zero()};
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
      const V atLow = factor * low * low;
      const V atHigh = factor * high * high;
      // The slope is -4 factor a d w.
      const V fa = factor * a;
      const V leastDw = fa * (hn::Min(d0, zero()) * high + hn::Max(d0, zero()) * low);
      const V mostDw = fa * (hn::Max(d1, zero()) * high + hn::Min(d1, zero()) * low);
      const V least = choose(adds, atLow, atHigh);
      const V most = choose(adds, atHigh, atLow);
      const V steepest = zero() - choose(adds, leastDw, mostDw);
      const V gentlest = zero() - choose(adds, mostDw, leastDw);
      sum.values = sum.values + hn::Abs(atHigh);
      sum.slopes = sum.slopes + hn::Max(hn::Abs(steepest), hn::Abs(gentlest));
      const V end = factor * w1 * w1;
      if (cliques_.empty() || term.slot == LaneTerm::kEverySum) {
        sum.least = sum.least + least;
        sum.atEnd = sum.atEnd + end;
        sum.steepest = sum.steepest + steepest;
        sum.gentlest = sum.gentlest + gentlest;
      } else {
        add(term.slot, kLeast, least);
        add(term.slot, kAtEnd, end);
        add(term.slot, kSteepest, steepest);
        add(term.slot, kGentlest, gentlest);
        add(term.slot, kMost, most);
      }
    }
    addWinners(sum);
    const V offset = skin_.value(t1);
    return {offset + sum.least,           all(4.0f) * sum.steepest, all(4.0f) * sum.gentlest,
            sum.values + hn::Abs(offset), all(4.0f) * sum.slopes,   offset + sum.atEnd};
  }

  /// F's sum is the largest: only cliques that may be it somewhere on the stretch have a say about slopes.
  void addWinners(Stretch& sum) const {
    if (cliques_.empty()) return;
    const V sign = skin_.sign;
    const M outward = hn::Gt(sign, zero());
    V surely = all(-std::numeric_limits<float>::infinity());  // F's sum is nowhere less.
    V least = surely;                                         // Times the sign, as is atEnd.
    V atEnd = surely;
    const std::size_t cliques = cliques_.begin.size() - 1;
    for (std::size_t k = 0; k < cliques; ++k) {
      const V low = sumOf(k, kLeast);
      const V high = sumOf(k, kMost);
      surely = hn::Max(surely, choose(outward, low, zero() - high));
      least = hn::Max(least, sign * low);
      atEnd = hn::Max(atEnd, sign * sumOf(k, kAtEnd));
    }
    V steepest = all(-std::numeric_limits<float>::infinity());
    V gentlest = all(std::numeric_limits<float>::infinity());
    for (std::size_t k = 0; k < cliques; ++k) {
      const V possibly = choose(outward, sumOf(k, kMost), zero() - sumOf(k, kLeast));
      const M wins = hn::Ge(possibly, surely);
      steepest = choose(wins, hn::Max(steepest, sumOf(k, kSteepest)), steepest);
      gentlest = choose(wins, hn::Min(gentlest, sumOf(k, kGentlest)), gentlest);
    }
    sum.least = sum.least + sign * least;
    sum.atEnd = sum.atEnd + sign * atEnd;
    sum.steepest = sum.steepest + steepest;
    sum.gentlest = sum.gentlest + gentlest;
  }
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
