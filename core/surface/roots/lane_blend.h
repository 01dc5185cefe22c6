// core/surface/roots/lane_blend.h: sums of terms by group along many rays, and the shares that cliques have of them
// with soft grooves. Included once per instruction set.
#if defined(SINEW_LANE_BLEND_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANE_BLEND_H
#undef SINEW_LANE_BLEND_H
#else
#define SINEW_LANE_BLEND_H
#endif

#include <span>

#include "core/geometry/at.h"
#include "core/geometry/lanes.h"
#include "core/rig/clique_lists.h"
#include "core/surface/roots/lane_terms.h"
#include "core/surface/roots/shape_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// For the lanes from `first` on.
class LaneBlend {
  /// Sums x_j and y_j of every slot.
  struct Sharing {
    const LaneBlend& lanes;
    std::size_t sums;
    std::size_t softness;

    HWY_INLINE V x(const SlotSums& slot) const { return lanes.sense_ * lanes.load(slot.of[sums]); }
    HWY_INLINE SlotSums& slot(int index) const { return lanes.sumsOf(index); }
    HWY_INLINE V y(int index) const { return lanes.sense_ * lanes.softnessOf(index, sums, softness); }
    HWY_INLINE std::size_t clique(int index) const {
      return static_cast<std::size_t>(at(lanes.scratch_.sharing, index));
    }
    HWY_INLINE LaneFloats& share(int index) const { return lanes.scratch_.shares[clique(index)]; }
    HWY_INLINE OwnSlots ownSlots(int first, int second) const {
      return {lanes.cliques_.slotsOf(clique(first)), lanes.cliques_.slotsOf(clique(second))};
    }
  };

  using Leveling = const Sharing&;
  static HWY_INLINE int levelCount(Leveling b) { return static_cast<int>(b.lanes.cliques_.count()); }
  static HWY_INLINE std::span<const int> ownOf(Leveling b, int clique) {
    return b.lanes.cliques_.slotsOf(static_cast<std::size_t>(clique));
  }
  static HWY_INLINE V sumOf(Leveling b, int clique) {
    V sum = zero();
    for (const int slot : ownOf(b, clique)) sum = sum + b.x(b.slot(slot));
    return sum;
  }
  static HWY_INLINE V softnessOf(Leveling b, int clique) {
    V sum = zero();
    for (const int slot : ownOf(b, clique)) sum = sum + b.y(slot);
    return sum;
  }
  // There are no more disjoint cliques than slots: the levels have room there.
  static HWY_INLINE void setLevel(Leveling b, int clique, Level level) {
    b.lanes.store(level.top, b.slot(clique).top);
    b.lanes.store(level.inverse, b.slot(clique).inverse);
  }
  static HWY_INLINE Level levelOf(Leveling b, int clique) {
    const SlotSums& slot = b.slot(clique);
    return {b.lanes.load(slot.top), b.lanes.load(slot.inverse)};
  }
  static HWY_INLINE void giveShare(Leveling b, int clique, V share) {
    for (const int slot : ownOf(b, clique)) b.lanes.store(share, b.slot(slot).share);
  }

  using Blending = const Sharing&;
  static HWY_INLINE int cliqueCount(Blending b) { return static_cast<int>(b.lanes.scratch_.sharing.size()); }
  static HWY_INLINE V shareOf(Blending b, int clique) { return b.lanes.load(b.share(clique)); }
  static HWY_INLINE Exchange exchangeOf(Blending b, int first, int second) {
    Exchange out{zero(), zero()};
    for (OwnSlots own = b.ownSlots(first, second); own.next();) {
      const SlotSums& slot = b.slot(own.slot());
      const V softness = b.y(own.slot());
      const V rate = softRate(b.x(slot), softness, b.lanes.load(slot.share));
      out.gain = own.ofFirst() ? out.gain + rate : out.gain - rate;
      out.fall = out.fall + softness;
    }
    return out;
  }
  static HWY_INLINE void exchange(Blending b, int first, int second, V given) {
    b.lanes.store(shareOf(b, first) + given, b.share(first));
    b.lanes.store(shareOf(b, second) - given, b.share(second));
    for (OwnSlots own = b.ownSlots(first, second); own.next();) {
      LaneFloats& share = b.slot(own.slot()).share;
      b.lanes.store(own.ofFirst() ? b.lanes.load(share) + given : b.lanes.load(share) - given, share);
    }
  }
#define formula static HWY_INLINE
#include "core/geometry/formulas/blend.h"
#undef formula

 public:
  /// @param sense  1 or -1: times it, sums are not negative.
  HWY_INLINE LaneBlend(LaneScratch& scratch, const LaneCliques& cliques, V sense, std::size_t first)
      : scratch_(scratch), cliques_(cliques), sense_(sense), first_(first) {}

  HWY_INLINE V load(const LaneFloats& floats) const { return hn::Load(kTag, floats.at(first_)); }
  HWY_INLINE void store(V value, LaneFloats& floats) const { hn::Store(value, kTag, floats.at(first_)); }

  HWY_INLINE bool isEverywhere(int slot) const { return cliques_.empty() || slot == LaneTerm::kEverySum; }
  /// @param used  how many sums of each slot are in use.
  HWY_INLINE void clearSums(std::size_t used) const {
    if (cliques_.empty()) return;
    for (std::size_t slot = 0; slot < cliques_.slotCount; ++slot) {
      for (std::size_t i = 0; i < used; ++i) store(zero(), scratch_.sums[slot].of[i]);
    }
  }
  HWY_INLINE void add(int slot, std::size_t which, V value) const {
    LaneFloats& sum = sumsOf(slot).of[which];
    store(load(sum) + value, sum);
  }
  HWY_INLINE V sumOf(std::size_t clique, std::size_t which) const {
    V sum = zero();
    for (const int slot : cliques_.slotsOf(clique)) sum = sum + load(sumsOf(slot).of[which]);
    return sum;
  }
  HWY_INLINE SlotSums& sumsOf(int slot) const { return scratch_.sums[static_cast<std::size_t>(slot)]; }

  // The rest is for soft grooves.

  /// y_j of a slot whose x_j is the sum `sums`; in `softness` if they are mixed.
  HWY_INLINE V softnessOf(int slot, std::size_t sums, std::size_t softness) const {
    const SlotSums& of = sumsOf(slot);
    return cliques_.mixed ? load(of.of[softness])
                          : all(cliques_.grooves[static_cast<std::size_t>(slot)]) * load(of.of[sums]);
  }

  /// Finds the shares of the cliques for sums x_j and y_j of every slot.
  HWY_INLINE void share(std::size_t sums, std::size_t softness) const {
    if (HWY_UNLIKELY(!cliques_.disjoint)) return exchangeShares({*this, sums, softness});
    levelShares({*this, sums, softness}, all(4e-6f), all(1e-6f));
    for (const int slot : cliques_.common) store(all(1.0f), sumsOf(slot).share);
  }

  /// softPart() of all slots with the shares found.
  HWY_INLINE V partOf(std::size_t sums, std::size_t softness) const {
    V out = zero();
    for (std::size_t i = 0; i < cliques_.slotCount; ++i) {
      const SlotSums& slot = scratch_.sums[i];
      out = out + softPart(load(slot.of[sums]), softnessOf(static_cast<int>(i), sums, softness), load(slot.share));
    }
    return out;
  }

 private:
  HWY_NOINLINE void exchangeShares(const Sharing& sharing) const {
    constexpr float kSettled = 1e-6f;  // Times the largest sum.
    V largest = zero();
    V highest = all(-1.0f);
    V surely = zero();
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      V sum = zero();
      V half = zero();
      for (const int slot : cliques_.slotsOf(k)) {
        sum = sum + sharing.x(sumsOf(slot));
        half = half + all(0.5f) * sharing.y(slot);
      }
      highest = select(hn::Gt(sum, largest), all(static_cast<float>(k)), highest);
      largest = hn::Max(largest, sum);
      surely = hn::Max(surely, sum - half);
      // An empty clique takes no part, whether it is among these or not.
      store(select(hn::Gt(sum, zero()), sum + half, all(-1.0f)), scratch_.shares[k]);
    }
    for (std::size_t slot = 0; slot < cliques_.slotCount; ++slot) store(zero(), scratch_.sums[slot].share);
    scratch_.sharing.clear();
    for (std::size_t k = 0; k < cliques_.count(); ++k) {
      // Taking from a clique b for k gains at most S_k + Y_k / 2 - S_b + Y_b / 2, with sums S and softness Y.
      const M mayShare = hn::Ge(load(scratch_.shares[k]), surely);
      if (!any(mayShare)) continue;
      const M wins = hn::Eq(highest, all(static_cast<float>(k)));
      const V whole = select(wins, all(1.0f), zero());
      store(select(mayShare, whole, all(-1.0f)), scratch_.shares[k]);
      scratch_.sharing.push_back(static_cast<int>(k));
      for (const int slot : cliques_.slotsOf(k)) store(load(sumsOf(slot).share) + whole, sumsOf(slot).share);
    }
    if (scratch_.sharing.size() > 1) settleShares(sharing, all(kSettled) * largest, hn::Gt(largest, zero()));
  }

  LaneScratch& scratch_;
  const LaneCliques& cliques_;
  V sense_;
  std::size_t first_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
