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
  // Exchanges of shares between cliques, for settleShares().
  struct LaneBlending {
    const RayLanes& rays;
    std::size_t sums;
    std::size_t softness;

    HWY_INLINE std::size_t clique(int index) const {
      return static_cast<std::size_t>(rays.scratch_.cliques[static_cast<std::size_t>(index)]);
    }
    HWY_INLINE LaneFloats& share(int index) const { return rays.scratch_.shares[clique(index)]; }

    /// Calls visit(slot, 1) for slots of the first clique alone, visit(slot, -1) for those of the second.
    template <class Visit>
    HWY_INLINE void forEachOwn(int first, int second, Visit visit) const {
      const LaneCliques& cliques = rays.cliques_;
      const auto slotAt = [&](int i) { return cliques.slots[static_cast<std::size_t>(i)]; };
      int i = cliques.begin[clique(first)];
      int j = cliques.begin[clique(second)];
      const int endOfFirst = cliques.begin[clique(first) + 1];
      const int endOfSecond = cliques.begin[clique(second) + 1];
      while (i < endOfFirst || j < endOfSecond) {
        if (j == endOfSecond || (i < endOfFirst && slotAt(i) < slotAt(j))) {
          visit(rays.sumsOf(slotAt(i++)), 1.0f);
        } else if (i == endOfFirst || slotAt(j) < slotAt(i)) {
          visit(rays.sumsOf(slotAt(j++)), -1.0f);
        } else {
          ++i;
          ++j;
        }
      }
    }
  };
  using Blending = const LaneBlending&;
  static HWY_INLINE int cliqueCount(Blending b) { return static_cast<int>(b.rays.scratch_.cliques.size()); }
  static HWY_INLINE V shareOf(Blending b, int clique) { return b.rays.load(b.share(clique)); }
  static HWY_INLINE Exchange exchangeOf(Blending b, int first, int second) {
    Exchange out{zero(), zero()};
    const V direction = b.rays.skin_.sense;
    b.forEachOwn(first, second, [&](SlotSums& slot, float sense) HWY_ATTR {
      const V softness = direction * b.rays.load(slot.of[b.softness]);
      const V rate = softRate(direction * b.rays.load(slot.of[b.sums]), softness, b.rays.load(slot.share));
      out.gain = out.gain + all(sense) * rate;
      out.fall = out.fall + softness;
    });
    return out;
  }
  static HWY_INLINE void exchange(Blending b, int first, int second, V given) {
    b.rays.store(b.rays.load(b.share(first)) + given, b.share(first));
    b.rays.store(b.rays.load(b.share(second)) - given, b.share(second));
    b.forEachOwn(first, second, [&](SlotSums& slot, float sense) HWY_ATTR {
      b.rays.store(b.rays.load(slot.share) + all(sense) * given, slot.share);
    });
  }
#define formula static HWY_INLINE
#include "core/geometry/formulas/blend.h"
#undef formula

 public:
  /// @param levels  if there are several; `cliques` are then those of the first
  RayLanes(LaneScratch& scratch, const LaneCliques& cliques, const LaneSkin& skin, std::size_t first,
           std::span<const LaneLevel> levels = {})
      : scratch_(scratch), cliques_(cliques), skin_(skin), first_(first), levels_(levels) {}

  HWY_INLINE std::span<const LaneTerm> terms() const { return {scratch_.terms.data(), scratch_.termCount}; }
  HWY_INLINE std::span<const LaneShape> shapes() const { return {scratch_.shapes.data(), scratch_.shapeCount}; }
  HWY_INLINE ShapeOnRays onRays(const LaneShape& shape) const { return {shape, first_}; }
  HWY_INLINE const LaneSkin& skin() const { return skin_; }

  Sample sample(V t) const {
    Sample sum{zero(), zero()};  // The derivative is divided by -4.
    clearSums(cliques_.soft ? 4 : 2);
    for (const LaneTerm& term : terms()) {
      const V d = t - load(term.middle);
      const V ad = load(term.a) * d;
      addSample(term, load(term.factor), {hn::Max(zero(), load(term.peak) - ad * d), ad}, sum);
    }
    // Passed by value: a sum with an address would be kept in memory by the loop above.
    if (HWY_UNLIKELY(!shapes().empty())) sum = withShapes(sum, t);
    if (!cliques_.empty()) sum = HWY_UNLIKELY(cliques_.soft || !levels_.empty()) ? blended(sum) : withWinner(sum);
    return {skin_.value(t) + sum.value, skin_.slope(t) - all(4.0f) * sum.slope};
  }

  /// Bounds of psi and its derivative on [t0, t1], by lane: the sum of those of the terms and of the skin.
  LaneBounds bounds(V t0, V t1) const {
    LaneBounds sum{zero(), zero(), zero(), zero(), zero(), zero()};
    clearSums(cliques_.soft ? 9 : 5);
    for (const LaneTerm& term : terms()) {
      const V middle = load(term.middle);
      addBounds(term, load(term.factor), ellipsoidBounds(load(term.a), load(term.peak), t0 - middle, t1 - middle), sum);
    }
    if (HWY_UNLIKELY(!shapes().empty())) sum = withShapes(sum, t0, t1);
    if (!cliques_.empty()) sum = HWY_UNLIKELY(!levels_.empty()) ? withLevels(sum) : withWinners(sum);
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
    march(to, rise.end, outward, cliques_.soft || !levels_.empty() ? 40 : 20, open,
          search);  // Outwards, psi is -T at the end.
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

  HWY_INLINE V load(const LaneFloats& floats) const { return hn::Load(kTag, floats.at(first_)); }

  // Sums of terms by group slot, for terms that are not in every sum.
  HWY_INLINE bool isEverywhere(int slot) const { return cliques_.empty() || slot == LaneTerm::kEverySum; }
  /// @param used  how many sums of each slot are in use.
  void clearSums(std::size_t used) const {
    if (cliques_.empty()) return;
    for (std::size_t slot = 0; slot < cliques_.slotCount; ++slot) {
      for (std::size_t i = 0; i < used; ++i) store(zero(), scratch_.sums[slot].of[i]);
    }
  }
  HWY_INLINE void add(int slot, std::size_t which, V value) const {
    LaneFloats& sum = scratch_.sums[static_cast<std::size_t>(slot)].of[which];
    store(load(sum) + value, sum);
  }
  HWY_INLINE SlotSums& sumsOf(int slot) const { return scratch_.sums[static_cast<std::size_t>(slot)]; }
  HWY_INLINE V sumOf(std::size_t clique, std::size_t which) const {
    V sum = zero();
    for (int i = cliques_.begin[clique]; i < cliques_.begin[clique + 1]; ++i) {
      const int slot = cliques_.slots[static_cast<std::size_t>(i)];
      sum = sum + load(scratch_.sums[static_cast<std::size_t>(slot)].of[which]);
    }
    return sum;
  }

  /// Soft grooves: finds the shares of the cliques for sums x_j and y_j of every slot, times the direction's sign.
  void share(std::size_t sums, std::size_t softness) const {
    if (cliques_.ownBegin.empty()) exchangeShares(sums, softness);
    else levelShares(sums, softness);
  }

  /// softPart() of all slots with the shares found.
  V partOf(std::size_t sums, std::size_t softness) const {
    V out = zero();
    for (std::size_t slot = 0; slot < cliques_.slotCount; ++slot) {
      const SlotSums& of = scratch_.sums[slot];
      out = out + softPart(load(of.of[sums]), load(of.of[softness]), load(of.share));
    }
    return out;
  }

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
  static constexpr float kSettled = 1e-6f;    ///< Times the largest sum.

  HWY_INLINE void store(V value, LaneFloats& floats) const { hn::Store(value, kTag, floats.at(first_)); }

  /// @param of  w and half the derivative of r^2.
  template <class Term>
  HWY_INLINE void addSample(const Term& term, V factor, const Sample& of, Sample& sum) const {
    const V value = potential(factor, of.value);
    const V slope = factor * potentialRate(of.value) * of.slope;
    if (isEverywhere(term.slot)) {
      sum.value = sum.value + value;
      sum.slope = sum.slope + slope;
      return;
    }
    add(term.slot, 0, value);
    add(term.slot, 1, slope);
    if (!cliques_.soft) return;
    add(term.slot, 2, all(term.groove) * value);
    add(term.slot, 3, all(term.groove) * slope);
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
    if (isEverywhere(slot)) {
      sum.value = sum.value + bounds.value.low;
      sum.atEnd = sum.atEnd + bounds.atEnd;
      sum.maxSlope = sum.maxSlope + bounds.slope.high;
      sum.minSlope = sum.minSlope + bounds.slope.low;
      return;
    }
    add(slot, kMin, bounds.value.low);
    add(slot, kAtEnd, bounds.atEnd);
    add(slot, kMaxSlope, bounds.slope.high);
    add(slot, kMinSlope, bounds.slope.low);
    add(slot, kMax, bounds.value.high);
    if (!cliques_.soft) return;
    const V groove = all(term.groove);
    add(slot, kSoftAtEnd, groove * bounds.atEnd);
    add(slot, kSoftMaxSlope, groove * bounds.slope.high);
    add(slot, kSoftMinSlope, groove * bounds.slope.low);
    add(slot, kSoftest, groove * bounds.most);
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
      const V value = sumOf(k, 0);
      const M wins = hn::Gt(skin_.sense * value, skin_.sense * best);
      best = select(wins, value, best);
      bestSlope = select(wins, sumOf(k, 1), bestSlope);
    }
    return {sum.value + best, sum.slope + bestSlope};
  }

  /// For cliques that share no group but those that all have. Where F is largest, a share changes it as much for every
  /// clique that has one: by rate = x + y / 2 - y share. The sum of the shares falls with the rate, by straight pieces
  /// that get less steep, so Newton's steps from below end at the rate for 1.
  void levelShares(std::size_t sums, std::size_t softness) const {
    const V sense = skin_.sense;
    V rate = zero();
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      V x = zero();
      V y = zero();
      forEachOwnSlot(k, [&](const SlotSums& slot) HWY_ATTR {
        x = x + load(slot.of[sums]);
        y = y + load(slot.of[softness]);
      });
      // A float could not tell a narrower groove's sums apart.
      const V soft = hn::Max(sense * y, all(4e-6f) * (sense * x));
      const V half = all(0.5f) * soft;
      rate = hn::Max(rate, sense * x - half);
      store(sense * x + half, scratch_.shares[k]);
      store(soft, scratch_.softness[k]);
    }
    scratch_.cliques.clear();
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      if (any(hn::Gt(load(scratch_.shares[k]), rate))) scratch_.cliques.push_back(static_cast<int>(k));
    }
    V have = zero();   // How many have a share,
    V whole = zero();  // and its sum.
    M open = hn::Ge(rate, zero());
    for (std::size_t step = 0; any(open); ++step) {
      V shares = zero();
      V holders = zero();
      V fall = zero();
      for (const int clique : scratch_.cliques) {
        const auto k = static_cast<std::size_t>(clique);
        const V above = load(scratch_.shares[k]) - rate;
        const V y = load(scratch_.softness[k]);
        const M has = both(hn::Gt(above, zero()), hn::Gt(y, zero()));
        shares = shares + select(has, above / y, zero());
        holders = holders + select(has, all(1.0f), zero());
        fall = fall + select(has, all(1.0f) / y, zero());
      }
      whole = select(open, shares, whole);
      have = select(open, holders, have);
      open = both(open, hn::Gt(shares, all(1.0f + 1e-6f)));
      if (step > cliques_.count()) break;
      rate = select(open, rate + (shares - all(1.0f)) / fall, rate);
    }
    for (std::size_t slot = 0; slot < cliques_.slotCount; ++slot) store(all(1.0f), scratch_.sums[slot].share);
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      const V above = load(scratch_.shares[k]) - rate;
      const V y = load(scratch_.softness[k]);
      const M has = both(hn::Gt(above, zero()), hn::Gt(y, zero()));
      const V own = select(has, select(hn::Gt(have, all(1.0f)), above / (y * whole), all(1.0f)), zero());
      forEachOwnSlot(k, [&](SlotSums& slot) HWY_ATTR { store(own, slot.share); });
    }
  }

  /// In pairs, for any cliques.
  void exchangeShares(std::size_t sums, std::size_t softness) const {
    const LaneBlending blending{*this, sums, softness};
    V largest = zero();
    V highest = all(-1.0f);
    V surely = zero();
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      const V sum = skin_.sense * sumOf(k, sums);
      const V half = all(0.5f) * skin_.sense * sumOf(k, softness);
      highest = select(hn::Gt(sum, largest), all(static_cast<float>(k)), highest);
      largest = hn::Max(largest, sum);
      surely = hn::Max(surely, sum - half);
      store(sum + half, scratch_.shares[k]);
    }
    clearShares();
    scratch_.cliques.clear();
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      // Taking from a clique b for k gains at most S_k + Y_k / 2 - S_b + Y_b / 2, with sums S and softness Y.
      const M mayShare = both(hn::Ge(load(scratch_.shares[k]), surely), hn::Gt(largest, zero()));
      const M wins = hn::Eq(highest, all(static_cast<float>(k)));
      if (!any(hn::Or(mayShare, wins))) continue;
      const V whole = select(wins, all(1.0f), zero());
      store(select(hn::Or(mayShare, wins), whole, all(-1.0f)), scratch_.shares[k]);
      scratch_.cliques.push_back(static_cast<int>(k));
      if (any(wins)) forEachSlot(k, [&](SlotSums& slot) HWY_ATTR { store(load(slot.share) + whole, slot.share); });
    }
    if (scratch_.cliques.size() > 1) settleShares(blending, all(kSettled) * largest, hn::Gt(largest, zero()));
  }

  HWY_INLINE Sample withShares(const Sample& sum) const {
    share(0, 2);
    return {sum.value + partOf(0, 2), sum.slope + partOf(1, 3)};
  }

  /// With soft grooves or several levels.
  HWY_NOINLINE Sample blended(Sample sum) const {
    if (levels_.empty()) return withShares(sum);
    for (const LaneLevel& level : levels_) {
      const RayLanes of(scratch_, level.cliques, skin_, first_);
      const Sample nothing{zero(), zero()};
      const Sample part = cliques_.soft ? of.withShares(nothing) : of.withWinner(nothing);
      sum.value = sum.value + all(level.weight) * part.value;
      sum.slope = sum.slope + all(level.weight) * part.slope;
    }
    return sum;
  }

  HWY_NOINLINE LaneBounds withLevels(LaneBounds sum) const {
    for (const LaneLevel& level : levels_) {
      const V weight = all(level.weight);
      const LaneBounds part = RayLanes(scratch_, level.cliques, skin_, first_)
                                  .withWinners({zero(), zero(), zero(), zero(), zero(), zero()});
      sum.value = sum.value + weight * part.value;
      sum.atEnd = sum.atEnd + weight * part.atEnd;
      sum.maxSlope = sum.maxSlope + weight * part.maxSlope;
      sum.minSlope = sum.minSlope + weight * part.minSlope;
    }
    return sum;
  }

  /// F is the largest of the cliques' sums, and with soft grooves up to sum y_j / 8 more: only those that may be the
  /// largest somewhere bound the derivative.
  HWY_INLINE LaneBounds withWinners(LaneBounds sum) const {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const V sign = skin_.sense;
    const M outward = hn::Gt(sign, zero());
    V surely = all(-kInfinity);  // F is nowhere less.
    V min = surely;              // Times the sign, like atEnd.
    V atEnd = surely;
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      const V low = sumOf(k, kMin);
      const V least = select(outward, low, zero() - sumOf(k, kMax));
      surely = hn::Max(surely, cliques_.soft ? least - all(0.5f) * sumOf(k, kSoftest) : least);
      min = hn::Max(min, sign * low);
      atEnd = hn::Max(atEnd, sign * sumOf(k, kAtEnd));
    }
    V maxSlope = all(-kInfinity);
    V minSlope = all(kInfinity);
    V mayWin = zero();
    if (cliques_.soft) clearShares();
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      const V most = select(outward, sumOf(k, kMax), zero() - sumOf(k, kMin));
      // An empty clique may tie with the others' least, but has no part then.
      const M wins = cliques_.soft ? hn::Gt(most + all(0.5f) * sumOf(k, kSoftest), surely) : hn::Ge(most, surely);
      if (cliques_.soft) {
        const V one = select(wins, all(1.0f), zero());
        mayWin = mayWin + one;
        forEachSlotWithShares(k, [&](SlotSums& slot) HWY_ATTR { store(hn::Max(load(slot.share), one), slot.share); });
      }
      maxSlope = select(wins, hn::Max(maxSlope, sumOf(k, kMaxSlope)), maxSlope);
      minSlope = select(wins, hn::Min(minSlope, sumOf(k, kMinSlope)), minSlope);
    }
    if (cliques_.soft) {
      const M empty = hn::Eq(mayWin, zero());
      maxSlope = select(empty, zero(), maxSlope);
      minSlope = select(empty, zero(), minSlope);
    }
    if (cliques_.soft && any(hn::Gt(mayWin, all(1.0f)))) {
      return withSoftness(sum, hn::Gt(mayWin, all(1.0f)),
                          {sign * min, maxSlope, minSlope, sum.values, sum.slopes, sign * atEnd});
    }
    sum.value = sum.value + sign * min;
    sum.atEnd = sum.atEnd + sign * atEnd;
    sum.maxSlope = sum.maxSlope + maxSlope;
    sum.minSlope = sum.minSlope + minSlope;
    return sum;
  }

  /// @param ofCliques  bounds as for crisp grooves.  @param blend  lanes where several cliques may have a share: then
  /// the slots that may have one between 0 and 1 have the share 1.
  HWY_NOINLINE LaneBounds withSoftness(LaneBounds sum, M blend, const LaneBounds& ofCliques) const {
    V softest = zero();
    V rises = zero();
    V falls = zero();
    for (std::size_t i = 0; i < cliques_.slotCount; ++i) {
      const SlotSums& slot = scratch_.sums[i];
      const V may = load(slot.share);
      softest = softest + may * load(slot.of[kSoftest]);
      rises = rises + may * hn::Max(zero(), load(slot.of[kSoftMaxSlope]));
      falls = falls + may * hn::Min(zero(), load(slot.of[kSoftMinSlope]));
    }
    share(kAtEnd, kSoftAtEnd);
    const auto part = [&](V of) HWY_ATTR { return select(blend, all(0.125f) * of, zero()); };
    const V higher = select(hn::Gt(skin_.sense, zero()), zero(), part(softest));
    sum.value = sum.value + ofCliques.value - higher;
    sum.atEnd = sum.atEnd + select(blend, partOf(kAtEnd, kSoftAtEnd), ofCliques.atEnd);
    sum.maxSlope = sum.maxSlope + ofCliques.maxSlope + part(rises);
    sum.minSlope = sum.minSlope + ofCliques.minSlope + part(falls);
    return sum;
  }

  void clearShares() const {
    for (std::size_t slot = 0; slot < cliques_.slotCount; ++slot) store(zero(), scratch_.sums[slot].share);
  }
  template <class Visit>
  HWY_INLINE void forEachOwnSlot(std::size_t clique, Visit visit) const {
    for (int i = cliques_.ownBegin[clique]; i < cliques_.ownBegin[clique + 1]; ++i) {
      visit(scratch_.sums[static_cast<std::size_t>(cliques_.ownSlots[static_cast<std::size_t>(i)])]);
    }
  }
  /// Those of its slots whose share depends on the cliques'.
  template <class Visit>
  HWY_INLINE void forEachSlotWithShares(std::size_t clique, Visit visit) const {
    if (cliques_.ownBegin.empty()) forEachSlot(clique, visit);
    else forEachOwnSlot(clique, visit);
  }
  template <class Visit>
  HWY_INLINE void forEachSlot(std::size_t clique, Visit visit) const {
    for (int i = cliques_.begin[clique]; i < cliques_.begin[clique + 1]; ++i) {
      visit(scratch_.sums[static_cast<std::size_t>(cliques_.slots[static_cast<std::size_t>(i)])]);
    }
  }

  LaneScratch& scratch_;
  const LaneCliques& cliques_;
  const LaneSkin& skin_;
  std::size_t first_;
  std::span<const LaneLevel> levels_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
