// core/geometry/lane_blocks.h: blocks of four numbers, as vectors lie in memory. Included once per instruction set.
#if defined(SINEW_LANE_BLOCKS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANE_BLOCKS_H
#undef SINEW_LANE_BLOCKS_H
#else
#define SINEW_LANE_BLOCKS_H
#endif

#include <cstddef>
#include <cstdint>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// kCount blocks of four numbers, in as few SIMD vectors as possible.
template <std::size_t kCount>
struct Blocks {
  using Tag = hn::CappedTag<float, 4 * kCount>;
  using Vector = hn::Vec<Tag>;
  static constexpr std::size_t kEach = hn::MaxLanes(Tag());
  static constexpr std::size_t kVectors = 4 * kCount / kEach;
  Vector of[kVectors];

  template <class Value>
  static HWY_INLINE Blocks make(Value value) {
    if constexpr (kVectors == 1) {
      return {{value(0)}};
    } else {
      static_assert(kVectors == 2);
      return {{value(0), value(1)}};
    }
  }
  static HWY_INLINE Blocks all(float value) {
    return make([=](std::size_t) HWY_ATTR { return hn::Set(Tag(), value); });
  }
  static HWY_INLINE Blocks load(const float* from) {
    return make([=](std::size_t i) HWY_ATTR { return hn::Load(Tag(), from + i * kEach); });
  }
  /// Half of the blocks from each of two places, which need not be aligned.
  static HWY_INLINE Blocks join(const float* low, const float* high) {
    const hn::CappedTag<float, 2 * kCount> half;
    if constexpr (kVectors == 1) {
      return {{hn::Combine(Tag(), hn::LoadU(half, high), hn::LoadU(half, low))}};
    } else {
      return {{hn::LoadU(half, low), hn::LoadU(half, high)}};
    }
  }
  HWY_INLINE void store(float* to) const {
    for (std::size_t i = 0; i < kVectors; ++i) hn::Store(of[i], Tag(), to + i * kEach);
  }
  /// Block by block, by the sixteen bytes' new places.
  [[nodiscard]] HWY_INLINE Blocks shuffle(const std::uint8_t* bytes) const {
    const hn::Repartition<std::uint8_t, Tag> byteTag;
    const auto order = hn::LoadDup128(byteTag, bytes);
    return make([&](std::size_t i)
                    HWY_ATTR { return hn::BitCast(Tag(), hn::TableLookupBytes(hn::BitCast(byteTag, of[i]), order)); });
  }
};

#define SINEW_BLOCKS_FUNCTION(name, parameters, expression)                          \
  template <std::size_t kCount>                                                      \
  HWY_INLINE Blocks<kCount> name parameters {                                        \
    [[maybe_unused]] const typename Blocks<kCount>::Tag tag;                         \
    return Blocks<kCount>::make([&](std::size_t i) HWY_ATTR { return expression; }); \
  }
#define SINEW_B const Blocks<kCount>&
SINEW_BLOCKS_FUNCTION(operator+, (SINEW_B a, SINEW_B b), hn::Add(a.of[i], b.of[i]))
SINEW_BLOCKS_FUNCTION(operator-, (SINEW_B a, SINEW_B b), hn::Sub(a.of[i], b.of[i]))
SINEW_BLOCKS_FUNCTION(operator*, (SINEW_B a, SINEW_B b), hn::Mul(a.of[i], b.of[i]))
SINEW_BLOCKS_FUNCTION(operator/, (SINEW_B a, SINEW_B b), hn::Div(a.of[i], b.of[i]))
SINEW_BLOCKS_FUNCTION(root, (SINEW_B a), hn::Sqrt(a.of[i]))
SINEW_BLOCKS_FUNCTION(magnitude, (SINEW_B a), hn::Abs(a.of[i]))
SINEW_BLOCKS_FUNCTION(min, (SINEW_B a, SINEW_B b), hn::Min(a.of[i], b.of[i]))
/// yes where `test` is below 0, else no.
SINEW_BLOCKS_FUNCTION(whereNegative, (SINEW_B test, SINEW_B yes, SINEW_B no),
                      hn::IfThenElse(hn::Lt(test.of[i], hn::Zero(tag)), yes.of[i], no.of[i]))
SINEW_BLOCKS_FUNCTION(max, (SINEW_B a, SINEW_B b), hn::Max(a.of[i], b.of[i]))
/// value where `test` is above 0, else 0.
SINEW_BLOCKS_FUNCTION(wherePositive, (SINEW_B test, SINEW_B value),
                      hn::IfThenElseZero(hn::Gt(test.of[i], hn::Zero(tag)), value.of[i]))
#undef SINEW_B
#undef SINEW_BLOCKS_FUNCTION

inline constexpr std::uint8_t kYzxw[16] = {4, 5, 6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 12, 13, 14, 15};
inline constexpr std::uint8_t kZxyw[16] = {8, 9, 10, 11, 0, 1, 2, 3, 4, 5, 6, 7, 12, 13, 14, 15};

/// (y, z, x, w)
template <std::size_t kCount>
HWY_INLINE Blocks<kCount> yzxw(const Blocks<kCount>& a) {
  return a.shuffle(kYzxw);
}
/// (z, x, y, w)
template <std::size_t kCount>
HWY_INLINE Blocks<kCount> zxyw(const Blocks<kCount>& a) {
  return a.shuffle(kZxyw);
}
template <int kNumber, std::size_t kCount>
HWY_INLINE Blocks<kCount> spread(const Blocks<kCount>& a) {
  return Blocks<kCount>::make([&](std::size_t i) HWY_ATTR { return hn::Broadcast<kNumber>(a.of[i]); });
}
/// x, y, z of the first and w of the second.
template <std::size_t kCount>
HWY_INLINE Blocks<kCount> xyzAndW(const Blocks<kCount>& xyz, const Blocks<kCount>& w) {
  using Tag = typename Blocks<kCount>::Tag;
  const hn::Repartition<std::uint32_t, Tag> bits;
  alignas(16) static constexpr std::uint32_t kW[4] = {0, 0, 0, ~0u};
  const auto isW = hn::MaskFromVec(hn::BitCast(Tag(), hn::LoadDup128(bits, kW)));
  return Blocks<kCount>::make([&](std::size_t i) HWY_ATTR { return hn::IfThenElse(isW, w.of[i], xyz.of[i]); });
}
/// (sum of a, sum of b, sum of c, sum of d), block by block.
template <std::size_t kCount>
HWY_INLINE Blocks<kCount> sums(const Blocks<kCount>& a, const Blocks<kCount>& b, const Blocks<kCount>& c,
                               const Blocks<kCount>& d) {
  using Tag = typename Blocks<kCount>::Tag;
  const Tag tag;
  const hn::RepartitionToWide<Tag> wide;
  return Blocks<kCount>::make([&](std::size_t i) HWY_ATTR {
    const auto ab = hn::BitCast(
        wide, hn::Add(hn::InterleaveLower(tag, a.of[i], b.of[i]), hn::InterleaveUpper(tag, a.of[i], b.of[i])));
    const auto cd = hn::BitCast(
        wide, hn::Add(hn::InterleaveLower(tag, c.of[i], d.of[i]), hn::InterleaveUpper(tag, c.of[i], d.of[i])));
    return hn::Add(hn::BitCast(tag, hn::InterleaveLower(wide, ab, cd)),
                   hn::BitCast(tag, hn::InterleaveUpper(wide, ab, cd)));
  });
}
template <std::size_t kCount>
HWY_INLINE Blocks<kCount / 2> lower(const Blocks<kCount>& a) {
  if constexpr (Blocks<kCount>::kVectors == 1) {
    return {{hn::LowerHalf(typename Blocks<kCount / 2>::Tag(), a.of[0])}};
  } else {
    return {{a.of[0]}};
  }
}
template <std::size_t kCount>
HWY_INLINE Blocks<kCount / 2> upper(const Blocks<kCount>& a) {
  if constexpr (Blocks<kCount>::kVectors == 1) {
    return {{hn::UpperHalf(typename Blocks<kCount / 2>::Tag(), a.of[0])}};
  } else {
    return {{a.of[1]}};
  }
}
template <std::size_t kCount>
HWY_INLINE Blocks<2 * kCount> bothOf(const Blocks<kCount>& low, const Blocks<kCount>& high) {
  using Many = Blocks<2 * kCount>;
  if constexpr (Many::kVectors == 1) {
    return {{hn::Combine(typename Many::Tag(), high.of[0], low.of[0])}};
  } else {
    return {{low.of[0], high.of[0]}};
  }
}
HWY_INLINE float first(const Blocks<1>& a) { return hn::GetLane(a.of[0]); }

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
