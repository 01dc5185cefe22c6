// core/lanes/double_lanes.h: formulas on vectors of doubles, one number a lane; of any width, so that one lane serves
// where there is one number. Included once per instruction set.
#if defined(SINEW_DOUBLE_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_DOUBLE_LANES_H
#undef SINEW_DOUBLE_LANES_H
#else
#define SINEW_DOUBLE_LANES_H
#endif

#include <cstdint>

#include "core/lanes/lane_doubles.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Multiplications and additions are never fused: every set gives the same bits.
using DoubleTag = hn::CappedTag<double, kDoubleLanes>;
using OneDouble = hn::CappedTag<double, 1>;

template <class V>
struct Vector3 {
  V x;
  V y;
  V z;
};

template <class V>
HWY_INLINE Vector3<V> operator+(const Vector3<V>& a, const Vector3<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
HWY_INLINE Vector3<V> operator-(const Vector3<V>& a, const Vector3<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
HWY_INLINE Vector3<V> operator*(V s, const Vector3<V>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class V>
HWY_INLINE V dot(const Vector3<V>& a, const Vector3<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
HWY_INLINE V lengthOf(const Vector3<V>& a) {
  return hn::Sqrt(dot(a, a));
}
template <class V>
HWY_INLINE Vector3<V> cross(const Vector3<V>& a, const Vector3<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class M, class V>
HWY_INLINE Vector3<V> choose(M mask, const Vector3<V>& yes, const Vector3<V>& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}
template <class D>
HWY_INLINE Vector3<hn::Vec<D>> load(D d, const LaneVectors& from, std::size_t first) {
  return {hn::Load(d, from.x.at(first)), hn::Load(d, from.y.at(first)), hn::Load(d, from.z.at(first))};
}
template <class D>
HWY_INLINE Vector3<hn::Vec<D>> all(D d, const glm::dvec3& v) {
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}
template <class D, class V>
HWY_INLINE V clamped(D d, V x, double least, double most) {
  return hn::Min(hn::Max(x, hn::Set(d, least)), hn::Set(d, most));
}

inline constexpr double kLn2High = 0x1.62e42feep-1;  ///< Its products with whole numbers below 2^21 are exact.
inline constexpr double kLn2Low = 0x1.a39ef35793c76p-33;

/// ln x to 2e-15 + 1e-13 |ln x|, for normal numbers above 0; any number for others.
template <class D, class V>
HWY_INLINE V naturalLog(D d, V x) {
  const hn::RebindToUnsigned<D> du;
  constexpr std::uint64_t kRootOfHalf = 0x3FE6A09E667F3BCD;
  constexpr std::uint64_t kOne = 0x3FF0000000000000;
  constexpr std::uint64_t kTwo52 = 0x4330000000000000;
  // x = 2^k m, m from sqrt(1/2) to sqrt(2).
  const auto shifted = hn::BitCast(du, x) + hn::Set(du, kOne - kRootOfHalf);
  const auto exponent = hn::Or(hn::ShiftRight<52>(shifted), hn::Set(du, kTwo52));
  const V k = hn::BitCast(d, exponent) - hn::Set(d, 0x1p52 + 1023.0);
  const auto fraction = hn::And(shifted, hn::Set(du, 0x000FFFFFFFFFFFFF)) + hn::Set(du, kRootOfHalf);
  const V m = hn::BitCast(d, fraction);
  // ln m = 2 atanh s.
  const V one = hn::Set(d, 1.0);
  const V s = (m - one) / (m + one);
  const V z = s * s;
  const V z2 = z * z;
  const V low = (one + hn::Set(d, 1.0 / 3.0) * z) + z2 * (hn::Set(d, 1.0 / 5.0) + hn::Set(d, 1.0 / 7.0) * z);
  const V high =
      (hn::Set(d, 1.0 / 9.0) + hn::Set(d, 1.0 / 11.0) * z) + z2 * (hn::Set(d, 1.0 / 13.0) + hn::Set(d, 1.0 / 15.0) * z);
  const V series = low + (z2 * z2) * high;
  return k * hn::Set(d, kLn2High) + (k * hn::Set(d, kLn2Low) + (s + s) * series);
}

/// e^x to 4e-13 of itself; x beyond 700 counts as 700, below -700 as -700. Not finite: any number.
template <class D, class V>
HWY_INLINE V exponential(D d, V x) {
  const hn::RebindToUnsigned<D> du;
  x = clamped(d, x, -700.0, 700.0);
  // x = k ln 2 + r; adding 1.5 * 2^52 rounds, and leaves k in the lowest bits.
  const V magic = hn::Set(d, 0x1.8p52);
  const V rounded = x * hn::Set(d, 0x1.71547652b82fep0) + magic;
  const V k = rounded - magic;
  const V r = (x - k * hn::Set(d, kLn2High)) - k * hn::Set(d, kLn2Low);
  const V r2 = r * r;
  const V r4 = r2 * r2;
  const V one = hn::Set(d, 1.0);
  const V low = (one + r) + r2 * (hn::Set(d, 1.0 / 2.0) + hn::Set(d, 1.0 / 6.0) * r);
  const V middle = (hn::Set(d, 1.0 / 24.0) + hn::Set(d, 1.0 / 120.0) * r) +
                   r2 * (hn::Set(d, 1.0 / 720.0) + hn::Set(d, 1.0 / 5040.0) * r);
  const V high = (hn::Set(d, 1.0 / 40320.0) + hn::Set(d, 1.0 / 362880.0) * r) + hn::Set(d, 1.0 / 3628800.0) * r2;
  const V series = low + r4 * (middle + r4 * high);
  const V power = hn::BitCast(d, hn::ShiftLeft<52>(hn::BitCast(du, rounded) + hn::Set(du, std::uint64_t{1023})));
  return series * power;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
