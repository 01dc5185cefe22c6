// core/geometry/lanes.h: numbers and vectors, one in each lane of the widest SIMD. Included once per instruction set.
#if defined(SINEW_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANES_H
#undef SINEW_LANES_H
#else
#define SINEW_LANES_H
#endif

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include <glm/mat3x3.hpp>

#include "core/geometry/lane_floats.h"
#include "hwy/highway.h"
#include "sinew/geometry/geometry.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Multiplications and additions are never fused: every set gives the same bits.
using FloatTag = hn::CappedTag<float, kLanes>;
using V = hn::Vec<FloatTag>;
using M = hn::Mask<FloatTag>;
constexpr FloatTag kTag;
HWY_INLINE std::size_t width() { return hn::Lanes(kTag); }
HWY_INLINE V all(float value) { return hn::Set(kTag, value); }
HWY_INLINE V zero() { return hn::Zero(kTag); }
HWY_INLINE bool any(M mask) { return !hn::AllFalse(kTag, mask); }
HWY_INLINE M both(M a, M b) { return hn::And(a, b); }
HWY_INLINE M andNot(M a, M b) { return hn::AndNot(b, a); }  ///< a without b.
HWY_INLINE M none() { return hn::Ne(zero(), zero()); }
HWY_INLINE V select(M mask, V yes, V no) { return hn::IfThenElse(mask, yes, no); }
HWY_INLINE V min(V a, V b) { return hn::Min(a, b); }
HWY_INLINE V max(V a, V b) { return hn::Max(a, b); }
HWY_INLINE V clamp(V x, V low, V high) { return hn::Min(hn::Max(x, low), high); }
HWY_INLINE V sqrt(V x) { return hn::Sqrt(x); }
HWY_INLINE V abs(V x) { return hn::Abs(x); }
/// 0 up to `from`, 1 from `to` on, between them 3 t^2 - 2 t^3.
HWY_INLINE V smoothstep(V from, V to, V x) {
  const V t = clamp((x - from) / (to - from), zero(), all(1.0f));
  return t * t * (all(3.0f) - all(2.0f) * t);
}

struct V3 {
  V x;
  V y;
  V z;

  friend HWY_INLINE V3 operator+(const V3& a, const V3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend HWY_INLINE V3 operator-(const V3& a, const V3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend HWY_INLINE V3 operator*(V s, const V3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend HWY_INLINE V3 operator*(const V3& a, V s) { return s * a; }
  friend HWY_INLINE V3 operator/(const V3& a, V s) { return {a.x / s, a.y / s, a.z / s}; }
};

HWY_INLINE V dot(const V3& a, const V3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE V3 cross(const V3& a, const V3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE V3 all(const glm::vec3& v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE V3 times(const glm::mat3& m, const V3& v) { return v.x * all(m[0]) + v.y * all(m[1]) + v.z * all(m[2]); }
HWY_INLINE V3 transposedTimes(const glm::mat3& m, const V3& v) {
  return {dot(all(m[0]), v), dot(all(m[1]), v), dot(all(m[2]), v)};
}
HWY_INLINE V3 select(M mask, const V3& yes, const V3& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

/// As normalizeOr() of sinew/geometry/geometry.h for lengths whose square is in a float's range; `fallback` for others.
HWY_INLINE V3 unitOr(const V3& v, const V3& fallback) {
  const V squared = dot(v, v);
  const M usual = both(hn::Gt(squared, all(1e-20f)), hn::Lt(squared, all(1e20f)));
  return select(usual, (all(1.0f) / hn::Sqrt(squared)) * v, fallback);
}

// For the formulas (core/geometry/formulas.h), which headers of lanes include where `formula` is HWY_INLINE.
using Real = V;
using Real3 = V3;
using Mask = M;
HWY_INLINE V num(double value) { return all(static_cast<float>(value)); }

/// Points or directions, one per lane of a tile.
struct LanePoints {
  LaneFloats x;
  LaneFloats y;
  LaneFloats z;

  /// Sets width() lanes from `first` on.
  void gather(std::span<const glm::vec3> from, const std::array<int, kLanes>& vertices, std::size_t first) {
    for (std::size_t lane = first; lane < first + width(); ++lane) {
      set(lane, from[static_cast<std::size_t>(vertices[lane])]);
    }
  }
  void set(std::size_t lane, const glm::vec3& v) {
    x.lane[lane] = v.x;
    y.lane[lane] = v.y;
    z.lane[lane] = v.z;
  }
  [[nodiscard]] glm::vec3 at(std::size_t lane) const { return {x.lane[lane], y.lane[lane], z.lane[lane]}; }
  HWY_INLINE V3 load(std::size_t first) const {
    return {hn::Load(kTag, x.at(first)), hn::Load(kTag, y.at(first)), hn::Load(kTag, z.at(first))};
  }
  HWY_INLINE void store(const V3& v, std::size_t first) {
    hn::Store(v.x, kTag, x.at(first));
    hn::Store(v.y, kTag, y.at(first));
    hn::Store(v.z, kTag, z.at(first));
  }
};

inline HWY_NOINLINE V3 normalizeLaneByLane(const V3& v, const V3& fallback) {
  LanePoints units;
  LanePoints fallbacks;
  units.store(v, 0);
  fallbacks.store(fallback, 0);
  for (std::size_t lane = 0; lane < width(); ++lane) {
    units.set(lane, sinew::normalizeOr(units.at(lane), fallbacks.at(lane)));
  }
  return units.load(0);
}

/// As normalizeOr() of sinew/geometry/geometry.h, bit for bit. Fast if the squares of all lengths are in a float's
/// range.
HWY_INLINE V3 normalizeOr(const V3& v, const V3& fallback) {
  const V squared = dot(v, v);
  const M usual = both(hn::Gt(squared, all(1e-20f)), hn::Lt(squared, all(1e20f)));
  if (HWY_UNLIKELY(!hn::AllTrue(kTag, usual))) return normalizeLaneByLane(v, fallback);
  return v / hn::Sqrt(squared);
}

/// Calls visit(first + lane) for every lane set in the mask.
template <class Visit>
HWY_INLINE void forEach(M mask, std::size_t first, Visit visit) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(kTag, mask, reinterpret_cast<std::uint8_t*>(&bits));
  for (; bits != 0; bits &= bits - 1) visit(first + static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Vectors readable as four numbers each, the fourth arbitrary; the last is copied, to read nothing beyond the span.
class Rows {
 public:
  explicit Rows(std::span<const glm::vec3> from) : from_(from) {
    if (!from.empty()) std::memcpy(last_, &from.back(), sizeof(glm::vec3));
  }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  [[nodiscard]] HWY_INLINE const float* at(int index) const {
    const auto i = static_cast<std::size_t>(index);
    return i + 1 < from_.size() ? &from_[i].x : last_;
  }

 private:
  std::span<const glm::vec3> from_;
  float last_[4] = {};
};

using RowPointers = std::array<const float*, kLanes>;  ///< The first width() are used.

/// Every fourth row, a block of four numbers each.
template <class Tag>
HWY_INLINE hn::Vec<Tag> everyFourth(Tag tag, const float* const* rows) {
  if constexpr (hn::MaxLanes(Tag()) == 4) {
    return hn::LoadU(tag, rows[0]);
  } else {
    const hn::Half<Tag> half;
    return hn::Combine(tag, everyFourth(half, rows + hn::MaxLanes(half)), everyFourth(half, rows));
  }
}

HWY_INLINE V3 gather(const RowPointers& rows) {
  const hn::RepartitionToWide<FloatTag> pairs;
  const V a = everyFourth(kTag, rows.data());
  const V b = everyFourth(kTag, rows.data() + 1);
  const V c = everyFourth(kTag, rows.data() + 2);
  const V d = everyFourth(kTag, rows.data() + 3);
  const auto abLow = hn::BitCast(pairs, hn::InterleaveLower(kTag, a, b));
  const auto cdLow = hn::BitCast(pairs, hn::InterleaveLower(kTag, c, d));
  const auto abHigh = hn::BitCast(pairs, hn::InterleaveUpper(kTag, a, b));
  const auto cdHigh = hn::BitCast(pairs, hn::InterleaveUpper(kTag, c, d));
  return {hn::BitCast(kTag, hn::InterleaveLower(pairs, abLow, cdLow)),
          hn::BitCast(kTag, hn::InterleaveUpper(pairs, abLow, cdLow)),
          hn::BitCast(kTag, hn::InterleaveLower(pairs, abHigh, cdHigh))};
}

/// Writes the first `used` lanes, each to place(lane).
template <class Place>
HWY_INLINE void scatterTo(const V3& v, Place place, std::size_t used) {
  const hn::RepartitionToWide<FloatTag> pairs;
  const auto xyLow = hn::BitCast(pairs, hn::InterleaveLower(kTag, v.x, v.y));
  const auto xyHigh = hn::BitCast(pairs, hn::InterleaveUpper(kTag, v.x, v.y));
  const auto zLow = hn::BitCast(pairs, hn::InterleaveLower(kTag, v.z, v.z));
  const auto zHigh = hn::BitCast(pairs, hn::InterleaveUpper(kTag, v.z, v.z));
  constexpr std::size_t kWidth = hn::MaxLanes(FloatTag());  // Lane 4 b + i in block b of row i.
  alignas(64) float rows[4 * kWidth];
  hn::Store(hn::BitCast(kTag, hn::InterleaveLower(pairs, xyLow, zLow)), kTag, rows);
  hn::Store(hn::BitCast(kTag, hn::InterleaveUpper(pairs, xyLow, zLow)), kTag, rows + kWidth);
  hn::Store(hn::BitCast(kTag, hn::InterleaveLower(pairs, xyHigh, zHigh)), kTag, rows + 2 * kWidth);
  hn::Store(hn::BitCast(kTag, hn::InterleaveUpper(pairs, xyHigh, zHigh)), kTag, rows + 3 * kWidth);
  const auto copy = [&](std::size_t lane) HWY_ATTR {
    std::memcpy(place(lane), rows + lane % 4 * kWidth + lane / 4 * 4, sizeof(glm::vec3));
  };
  std::size_t lane = 0;
  for (; lane + 4 <= used; lane += 4) {
    copy(lane);
    copy(lane + 1);
    copy(lane + 2);
    copy(lane + 3);
  }
  for (; lane < used; ++lane) copy(lane);
}

/// Writes the first `used` lanes to every `stride`-th place from `to` on.
HWY_INLINE void scatter(const V3& v, glm::vec3* to, std::size_t stride, std::size_t used) {
  scatterTo(
      v, [=](std::size_t lane) { return to + lane * stride; }, used);
}

/// Reads row(lane) for every lane.
template <class Row>
HWY_INLINE V3 gatherBy(Row row) {
  RowPointers rows;
  for (std::size_t lane = 0; lane < width(); ++lane) rows[lane] = row(lane);
  return gather(rows);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
