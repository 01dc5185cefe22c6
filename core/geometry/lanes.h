// core/geometry/lanes.h: one number a lane, in as wide a vector as there is. Included once per instruction set.
#if defined(SINEW_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANES_H
#undef SINEW_LANES_H
#else
#define SINEW_LANES_H
#endif

#include <cstddef>

#include "core/geometry/lane_floats.h"
#include "hwy/highway.h"

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
/// a without b.
HWY_INLINE M andNot(M a, M b) { return hn::AndNot(b, a); }
HWY_INLINE M none() { return hn::Ne(zero(), zero()); }
HWY_INLINE V select(M mask, V yes, V no) { return hn::IfThenElse(mask, yes, no); }

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
