// core/surface/roots/ray_lanes.h: the field along many rays at once, and brackets around its first changes of sign.
// Included once per instruction set. docs/performance.md has the proofs.
#if defined(SINEW_RAY_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_RAY_LANES_H
#undef SINEW_RAY_LANES_H
#else
#define SINEW_RAY_LANES_H
#endif

#include <limits>
#include <span>

#include "core/geometry/lanes.h"
#include "core/surface/roots/lane_blend.h"
#include "core/surface/roots/lane_terms.h"
#include "core/surface/roots/shape_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// The skin's own field minus T, times the direction's sign: falls from 0 at t = 0.
struct LaneSkin : SkinRay {
  bool falls;  ///< False: the skin has no field; only `sense` and `offset` count.
  V offset;    ///< Added everywhere.

  HWY_INLINE V value(V t) const { return falls ? offset + skinValue(*this, t) : offset; }
  HWY_INLINE V slope(V t) const { return falls ? all(-4.0f) * skinSlope(*this, t) : zero(); }
};

/// Bounds on a whole interval of every ray.
struct LaneBounds {
  V value;  ///< Least value of psi.
  V maxSlope;
  V minSlope;
  V values;  ///< Sum of the magnitudes in `value`, and in the slopes: they bound rounding.
  V slopes;
  V atEnd;  ///< psi at the interval's end.
};

/// State of every ray's search.
struct LaneSearch {
  V low;   ///< psi > 0 up to here.
  V high;  ///< If bracketed, a root lies between these two, and psi only falls there.
  M bracketed;
  M rootless;  ///< psi > 0 up to the end.
};

/// Where along each ray psi might rise.
struct LaneRise {
  V from;  ///< psi falls before this,
  V to;    ///< and after this.
  V end;   ///< End of the search.
};

/// Whether a term is positive at some t >= 0: at its middle, or at 0 by the same operations as in sample().
HWY_INLINE M liesAhead(V a, V middle, V peak) {
  const V atStart = peak - a * middle * middle;
  return both(hn::Gt(peak, zero()), hn::Or(hn::Gt(middle, zero()), hn::Gt(atStart, zero())));
}

/// psi along the rays of the lanes from `first` on.
class RayLanes {
 public:
  RayLanes(LaneScratch& scratch, const LaneLevels& levels, const LaneSkin& skin, std::size_t first)
      : RayLanes(scratch, levels.first, levels.several, skin, first) {}

  HWY_INLINE std::span<const LaneTerm> terms() const { return {scratch_.terms.data(), scratch_.termCount}; }
  HWY_INLINE std::span<const LaneShape> shapes() const { return {scratch_.shapes.data(), scratch_.shapeCount}; }
  HWY_INLINE ShapeOnRays onRays(const LaneShape& shape) const { return {shape, first_}; }
  HWY_INLINE const LaneSkin& skin() const { return skin_; }
  HWY_INLINE const LaneBlend& blend() const { return blend_; }
  HWY_INLINE const LaneCliques& cliques() const { return cliques_; }  ///< Of the first level.
  HWY_INLINE std::span<const LaneLevel> levels() const { return levels_; }
  /// The same rays with one of several levels alone. Has the same sums.
  HWY_INLINE RayLanes with(const LaneLevel& level) const { return {scratch_, level.cliques, {}, skin_, first_}; }

  Sample sample(V t) const {
    Sample sum{zero(), zero()};  // The derivative is divided by -4.
    blend_.clearSums(cliques_.mixed ? 4 : 2);
    for (const LaneTerm& term : terms()) {
      const V d = t - load(term.middle);
      const V ad = load(term.a) * d;
      addSample(term, load(term.factor), {hn::Max(zero(), load(term.peak) - ad * d), ad}, sum);
    }
    // Passed by value: a sum with an address would be kept in memory by the loop above.
    if (HWY_UNLIKELY(!shapes().empty())) sum = withShapes(sum, t);
    if (!cliques_.empty()) sum = HWY_UNLIKELY(isBlended()) ? blended(sum) : withWinner(sum);
    return {skin_.value(t) + sum.value, skin_.slope(t) - all(4.0f) * sum.slope};
  }

  /// Bounds of psi and its derivative on [t0, t1], by lane: the sum of those of the terms and of the skin.
  LaneBounds bounds(V t0, V t1) const {
    LaneBounds sum{zero(), zero(), zero(), zero(), zero(), zero()};
    blend_.clearSums(cliques_.mixed ? 9 : 5);
    for (const LaneTerm& term : terms()) {
      const V middle = load(term.middle);
      addBounds(term, load(term.factor), ellipsoidBounds(load(term.a), load(term.peak), t0 - middle, t1 - middle), sum);
    }
    if (HWY_UNLIKELY(!shapes().empty())) sum = withShapes(sum, t0, t1);
    if (!cliques_.empty()) sum = HWY_UNLIKELY(isBlended()) ? blendedBounds(sum) : withWinners(sum);
    const V skin = skin_.value(t1);
    LaneBounds psi{skin + sum.value,           sum.maxSlope, sum.minSlope,
                   sum.values + hn::Abs(skin), sum.slopes,   skin + sum.atEnd};
    if (skin_.falls) {
      // The factors of the skin's derivative are monotone: their least and largest values are at the ends.
      const Range radius = rangeOf(skinRadius(skin_, t0), skinRadius(skin_, t1));
      const Range rate = rangeOf(skinRate(skin_, t0), skinRate(skin_, t1));
      const V fall = skin_.inverseWidth * radius.high * rate.high;
      psi.maxSlope = psi.maxSlope - skin_.inverseWidth * radius.low * rate.low;
      psi.minSlope = psi.minSlope - fall;
      psi.slopes = psi.slopes + fall;
    }
    const V four = all(4.0f);
    psi.maxSlope = four * psi.maxSlope;
    psi.minSlope = four * psi.minSlope;
    psi.slopes = four * psi.slopes;
    return psi;
  }

  /// Brackets the first change of sign of the active lanes' rays, which start on the skin with psi > 0. Lanes that end
  /// up neither bracketed nor rootless have no certificate. No lane depends on its neighbors.
  LaneSearch bracketFromSkin(const LaneRise& rise, M active) const {
    const M outward = hn::Gt(skin_.sense, zero());
    const M falls = hn::Ge(rise.from, rise.end);
    const V from = hn::Min(rise.from, rise.end);
    LaneSearch search{zero(), from, both(both(active, falls), outward), none()};
    M open = andNot(active, search.bracketed);
    if (!any(open)) return search;
    const V value = sample(from).value;
    const M below = both(open, hn::Le(value, zero()));
    const M above = both(open, hn::Gt(value, zero()));
    search.bracketed = hn::Or(search.bracketed, below);
    search.rootless = both(above, falls);
    open = andNot(above, falls);
    const V to = hn::Min(rise.to, rise.end);
    search.low = select(open, from, search.low);
    search.high = select(open, to, search.high);
    march(to, rise.end, outward, isBlended() ? 40 : 20, open, search);  // Outwards, psi is -T at the end.
    return search;
  }

  /// The same between `begin` and `end` for rays without skin, along which psi may rise and fall anywhere. A lane with
  /// psi <= 0 at `begin` has its root there.
  LaneSearch bracketBetween(V begin, V end, M active) const {
    LaneSearch search{begin, end, none(), andNot(active, hn::Lt(begin, end))};
    M open = andNot(active, search.rootless);
    if (!any(open)) return search;
    search.bracketed = both(open, hn::Le(sample(begin).value, zero()));
    open = andNot(open, search.bracketed);
    search.high = select(search.bracketed, begin, end);
    march(end, end, none(), 40, open, search);
    return search;
  }

  HWY_INLINE V load(const LaneFloats& floats) const { return blend_.load(floats); }

  /// Where an ellipsoid's influence begins and ends along the rays that meet it.
  HWY_INLINE Range extentOf(const LaneTerm& term) const {
    const V half = hn::Sqrt(hn::Max(zero(), load(term.peak)) / load(term.a));
    return {load(term.middle) - half, load(term.middle) + half};
  }

 private:
  static constexpr std::size_t kMin = 0;
  static constexpr std::size_t kAtEnd = 1;
  static constexpr std::size_t kMaxSlope = 2;
  static constexpr std::size_t kMinSlope = 3;
  static constexpr std::size_t kMax = 4;
  static constexpr std::size_t kSoftAtEnd = 5;  ///< The same for y_j,
  static constexpr std::size_t kSoftMaxSlope = 6;
  static constexpr std::size_t kSoftMinSlope = 7;
  static constexpr std::size_t kSoftest = 8;  ///< and its largest magnitude.

  /// @param levels  if there are several; `cliques` are then those of the first.
  RayLanes(LaneScratch& scratch, const LaneCliques& cliques, std::span<const LaneLevel> levels, const LaneSkin& skin,
           std::size_t first)
      : blend_(scratch, cliques, skin.sense, first),
        scratch_(scratch),
        cliques_(cliques),
        levels_(levels),
        skin_(skin),
        first_(first) {}

  /// With soft grooves or several levels.
  HWY_INLINE bool isBlended() const { return cliques_.soft || !levels_.empty(); }

  /// @param of  w and half the derivative of r^2.
  template <class Term>
  HWY_INLINE void addSample(const Term& term, V factor, const Sample& of, Sample& sum) const {
    const V value = potential(factor, of.value);
    const V slope = factor * potentialRate(of.value) * of.slope;
    if (blend_.isEverywhere(term.slot)) {
      sum.value = sum.value + value;
      sum.slope = sum.slope + slope;
      return;
    }
    blend_.add(term.slot, 0, value);
    blend_.add(term.slot, 1, slope);
    if (!cliques_.mixed) return;
    blend_.add(term.slot, 2, all(term.groove) * value);
    blend_.add(term.slot, 3, all(term.groove) * slope);
  }

  HWY_NOINLINE Sample withShapes(Sample sum, V t) const {
    for (const LaneShape& shape : shapes()) {
      const ShapeOnRays ray = onRays(shape);
      addSample(shape, ray.factor(), ray.sample(t), sum);
    }
    return sum;
  }

  HWY_NOINLINE LaneBounds withShapes(LaneBounds sum, V t0, V t1) const {
    for (const LaneShape& shape : shapes()) {
      const ShapeOnRays ray = onRays(shape);
      addBounds(shape, ray.factor(), ray.bounds(t0, t1), sum);
    }
    return sum;
  }

  template <class Term>
  HWY_INLINE void addBounds(const Term& term, V factor, const PotentialBounds& of, LaneBounds& sum) const {
    const TermBounds bounds = termBounds(factor, of);
    sum.values = sum.values + bounds.most;
    sum.slopes = sum.slopes + hn::Max(hn::Abs(bounds.slope.high), hn::Abs(bounds.slope.low));
    const int slot = term.slot;
    if (blend_.isEverywhere(slot)) {
      sum.value = sum.value + bounds.value.low;
      sum.atEnd = sum.atEnd + bounds.atEnd;
      sum.maxSlope = sum.maxSlope + bounds.slope.high;
      sum.minSlope = sum.minSlope + bounds.slope.low;
      return;
    }
    blend_.add(slot, kMin, bounds.value.low);
    blend_.add(slot, kAtEnd, bounds.atEnd);
    blend_.add(slot, kMaxSlope, bounds.slope.high);
    blend_.add(slot, kMinSlope, bounds.slope.low);
    blend_.add(slot, kMax, bounds.value.high);
    if (!cliques_.mixed) return;
    const V groove = all(term.groove);
    blend_.add(slot, kSoftAtEnd, groove * bounds.atEnd);
    blend_.add(slot, kSoftMaxSlope, groove * bounds.slope.high);
    blend_.add(slot, kSoftMinSlope, groove * bounds.slope.low);
    blend_.add(slot, kSoftest, groove * bounds.most);
  }

  /// Goes interval by interval from search.low to `end`; the first ends at search.high. It passes an interval if bounds
  /// prove that psi stays positive or only rises there, finds the root in it if they prove that psi falls through 0,
  /// and halves it otherwise.
  /// @param to  psi only falls from here to `end`.  @param endsBelow  lanes where psi is known to be negative at `end`.
  void march(V to, V end, M endsBelow, int maxStretches, M open, LaneSearch& search) const {
    V low = search.low;
    V high = search.high;
    for (int i = 0; i < maxStretches && any(open); ++i) {
      const LaneBounds seen = bounds(low, high);
      V least = seen.value;
      if (cliques_.soft) {
        // The bound of the value alone does not become tight where intervals get short.
        least = hn::Max(least, seen.atEnd - hn::Max(zero(), seen.maxSlope) * (high - low));
      }
      const M clear = hn::Gt(least, all(1e-5f) * seen.values);
      const V enough = all(1e-3f) * seen.slopes;
      const M rises = hn::Ge(seen.minSlope, enough);
      const M falls = hn::Le(seen.maxSlope, zero() - enough);
      const M found = both(both(open, falls), hn::Le(seen.atEnd, zero()));
      const M passed = both(open, hn::Or(hn::Or(clear, rises), both(falls, hn::Gt(seen.atEnd, zero()))));
      search.bracketed = hn::Or(search.bracketed, found);
      open = andNot(open, found);
      const V length = high - low;
      const V halved = low + all(0.5f) * length;
      low = select(passed, high, low);
      const M over = both(passed, hn::Ge(low, to));
      const M ended = both(over, hn::Ge(low, end));
      search.rootless = hn::Or(search.rootless, ended);
      const V onward = select(hn::Lt(low, to), hn::Min(low + length + length, to), end);
      high = select(open, select(passed, onward, halved), high);
      const M lastFall = both(andNot(over, ended), endsBelow);
      search.bracketed = hn::Or(search.bracketed, lastFall);
      open = andNot(open, hn::Or(ended, lastFall));
    }
    search.low = low;
    search.high = high;
  }

  /// Sum of the clique with the largest F; where psi's sign is negative, with the least psi.
  HWY_INLINE Sample withWinner(const Sample& sum) const {
    V best = zero();
    V bestSlope = zero();
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      const V value = blend_.sumOf(k, 0);
      const M wins = hn::Gt(skin_.sense * value, skin_.sense * best);
      best = select(wins, value, best);
      bestSlope = select(wins, blend_.sumOf(k, 1), bestSlope);
    }
    return {sum.value + best, sum.slope + bestSlope};
  }

  HWY_INLINE Sample withShares(const Sample& sum) const {
    blend_.share(0, 2);
    return {sum.value + blend_.partOf(0, 2), sum.slope + blend_.partOf(1, 3)};
  }

  HWY_NOINLINE Sample blended(Sample sum) const {
    if (HWY_LIKELY(levels_.empty())) return withShares(sum);
    for (const LaneLevel& level : levels_) {
      const RayLanes of = with(level);
      const Sample nothing{zero(), zero()};
      const Sample part = cliques_.soft ? of.withShares(nothing) : of.withWinner(nothing);
      sum.value = sum.value + all(level.weight) * part.value;
      sum.slope = sum.slope + all(level.weight) * part.slope;
    }
    return sum;
  }

  /// F is the largest of the cliques' sums: only those that may be the largest somewhere bound the derivative.
  HWY_INLINE LaneBounds withWinners(LaneBounds sum) const {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const V sign = skin_.sense;
    const M outward = hn::Gt(sign, zero());
    V surely = all(-kInfinity);  // F is nowhere less.
    V min = surely;              // Times the sign, like atEnd.
    V atEnd = surely;
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      const V low = blend_.sumOf(k, kMin);
      surely = hn::Max(surely, select(outward, low, zero() - blend_.sumOf(k, kMax)));
      min = hn::Max(min, sign * low);
      atEnd = hn::Max(atEnd, sign * blend_.sumOf(k, kAtEnd));
    }
    V maxSlope = all(-kInfinity);
    V minSlope = all(kInfinity);
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      const M wins = hn::Ge(select(outward, blend_.sumOf(k, kMax), zero() - blend_.sumOf(k, kMin)), surely);
      maxSlope = select(wins, hn::Max(maxSlope, blend_.sumOf(k, kMaxSlope)), maxSlope);
      minSlope = select(wins, hn::Min(minSlope, blend_.sumOf(k, kMinSlope)), minSlope);
    }
    sum.value = sum.value + sign * min;
    sum.atEnd = sum.atEnd + sign * atEnd;
    sum.maxSlope = sum.maxSlope + maxSlope;
    sum.minSlope = sum.minSlope + minSlope;
    return sum;
  }

  HWY_NOINLINE LaneBounds blendedBounds(LaneBounds sum) const {
    if (HWY_LIKELY(levels_.empty())) return boundsWithShares(sum);
    for (const LaneLevel& level : levels_) {
      const V weight = all(level.weight);
      const RayLanes of = with(level);
      const LaneBounds nothing{zero(), zero(), zero(), zero(), zero(), zero()};
      const LaneBounds part = cliques_.soft ? of.boundsWithShares(nothing) : of.withWinners(nothing);
      sum.value = sum.value + weight * part.value;
      sum.atEnd = sum.atEnd + weight * part.atEnd;
      sum.maxSlope = sum.maxSlope + weight * part.maxSlope;
      sum.minSlope = sum.minSlope + weight * part.minSlope;
    }
    return sum;
  }

  /// y_j's largest magnitude.
  HWY_INLINE V softestOf(int slot) const {
    const SlotSums& of = blend_.sumsOf(slot);
    if (cliques_.mixed) return load(of.of[kSoftest]);
    const M outward = hn::Gt(skin_.sense, zero());
    return all(cliques_.grooves[static_cast<std::size_t>(slot)]) *
           select(outward, load(of.of[kMax]), zero() - load(of.of[kMin]));
  }

  /// The same with soft grooves: F is up to sum y_j / 8 more than the largest sum. A clique of sum 0 has no part.
  HWY_NOINLINE LaneBounds boundsWithShares(LaneBounds sum) const {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const V sign = skin_.sense;
    const M outward = hn::Gt(sign, zero());
    V common = zero();  // At the end.
    for (const int slot : cliques_.common) {
      const SlotSums& of = blend_.sumsOf(slot);
      sum.value = sum.value + load(of.of[kMin]);
      sum.maxSlope = sum.maxSlope + load(of.of[kMaxSlope]);
      sum.minSlope = sum.minSlope + load(of.of[kMinSlope]);
      common = common + load(of.of[kAtEnd]);
    }
    V surely = zero();
    V min = zero();
    V atEnd = zero();
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      const V low = blend_.sumOf(k, kMin);
      V softest = zero();
      for (const int slot : cliques_.slotsOf(k)) softest = softest + softestOf(slot);
      surely = hn::Max(surely, select(outward, low, zero() - blend_.sumOf(k, kMax)) - all(0.5f) * softest);
      min = hn::Max(min, sign * low);
      atEnd = hn::Max(atEnd, sign * blend_.sumOf(k, kAtEnd));
    }
    V maxSlope = all(-kInfinity);
    V minSlope = all(kInfinity);
    V mayWin = zero();
    for (std::size_t slot = 0; slot < cliques_.slotCount; ++slot) blend_.store(zero(), scratch_.sums[slot].share);
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      V most = select(outward, blend_.sumOf(k, kMax), zero() - blend_.sumOf(k, kMin));
      for (const int slot : cliques_.slotsOf(k)) most = most + all(0.5f) * softestOf(slot);
      const M wins = hn::Gt(most, surely);
      const V one = select(wins, all(1.0f), zero());
      mayWin = mayWin + one;
      for (const int slot : cliques_.slotsOf(k)) {
        LaneFloats& share = blend_.sumsOf(slot).share;
        blend_.store(hn::Max(load(share), one), share);
      }
      maxSlope = select(wins, hn::Max(maxSlope, blend_.sumOf(k, kMaxSlope)), maxSlope);
      minSlope = select(wins, hn::Min(minSlope, blend_.sumOf(k, kMinSlope)), minSlope);
    }
    const M empty = hn::Eq(mayWin, zero());
    const M blend = hn::Gt(mayWin, all(1.0f));
    sum.value = sum.value + sign * min;
    sum.maxSlope = sum.maxSlope + select(empty, zero(), maxSlope);
    sum.minSlope = sum.minSlope + select(empty, zero(), minSlope);
    if (!any(blend)) {
      sum.atEnd = sum.atEnd + (common + sign * atEnd);
      return sum;
    }
    V softest = zero();
    V rises = zero();
    V falls = zero();
    for (std::size_t i = 0; i < cliques_.slotCount; ++i) {
      const V may = load(scratch_.sums[i].share);
      const int slot = static_cast<int>(i);
      softest = softest + may * softestOf(slot);
      rises = rises + may * hn::Max(zero(), blend_.softnessOf(slot, kMaxSlope, kSoftMaxSlope));
      falls = falls + may * hn::Min(zero(), blend_.softnessOf(slot, kMinSlope, kSoftMinSlope));
    }
    const auto part = [&](V of) HWY_ATTR { return select(blend, all(0.125f) * of, zero()); };
    sum.value = sum.value - select(outward, zero(), part(softest));
    sum.maxSlope = sum.maxSlope + part(rises);
    sum.minSlope = sum.minSlope + part(falls);
    blend_.share(kAtEnd, kSoftAtEnd);
    sum.atEnd = sum.atEnd + select(blend, blend_.partOf(kAtEnd, kSoftAtEnd), common + sign * atEnd);
    return sum;
  }

  LaneBlend blend_;
  LaneScratch& scratch_;
  const LaneCliques& cliques_;
  std::span<const LaneLevel> levels_;
  const LaneSkin& skin_;
  std::size_t first_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
