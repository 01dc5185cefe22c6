// core/lines/line_formulas.h: how a muscle answers to the length and the bend of its line, on vectors of any width; one
// lane where there is one line. docs/lines.md. Included once per instruction set.
#if defined(SINEW_LINE_FORMULAS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LINE_FORMULAS_H
#undef SINEW_LINE_FORMULAS_H
#else
#define SINEW_LINE_FORMULAS_H
#endif

#include "core/lanes/double_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Belly stretch of a line's stretch: tendons keep their length. @param belly  of the rest length
template <class D, class V>
HWY_INLINE V bellyStretchOf(D d, V stretch, V belly) {
  constexpr double kLeast = 0.1;  // Of the rest length's belly, however short the line.
  const V tendons = hn::Set(d, 1.0) - belly;
  return hn::Max(stretch - tendons, hn::Set(d, kLeast) * belly) / belly;
}

/// ln of a stretch, levelling off at both limits; slope 1 at rest. @param least, most  as GirthRest
template <class D, class V>
HWY_INLINE V softened(D d, V stretch, V least, V most) {
  const V one = hn::Set(d, 1.0);
  const V x = naturalLog(d, stretch);
  const V limit = hn::IfThenElse(hn::Lt(x, hn::Zero(d)), least, most);
  const V e = exponential(d, clamped(d, (x + x) / limit, -80.0, 80.0));
  return limit * ((e - one) / (e + one));  // The hyperbolic tangent.
}

/// @param exponent  -volume / 2. @param inBind  softened() in the bind pose
template <class D, class V>
HWY_INLINE V girthOf(D d, V stretch, V exponent, V least, V most, V inBind) {
  return exponential(d, exponent * (softened(d, stretch, least, most) - inBind));
}

/// @param base  with what is added to it
template <class D, class V>
HWY_INLINE V activationOf(D d, V stretch, V full, V base, V gain) {
  const V one = hn::Set(d, 1.0);
  const V shortened = clamped(d, (one - stretch) / (one - full), 0.0, 1.0);
  const V smooth = shortened * shortened * (hn::Set(d, 3.0) - (shortened + shortened));
  return clamped(d, base + gain * smooth, 0.0, 1.0);
}

/// How much farther out than the via point the middle of the belly goes, for a via point at y, -1 and 1 being the
/// belly's ends: as a parabola through it, 1 / (1 - y^2), over the middle 0.6; towards the ends, where no parabola
/// holds, the factor fades to 1, and stays that. C1, at most 1.94.
template <class D, class V>
HWY_INLINE V viaFactor(D d, V y) {
  constexpr double kParabola = 0.6;
  const V one = hn::Set(d, 1.0);
  const V away = hn::Min(hn::Abs(y), one);
  const V t = (one - away) / hn::Set(d, 1.0 - kParabola);
  // t^3 (10 - 15 t + 6 t^2) y^2 / (1 - y^2), without its 0 / 0.
  const V fade = t * t * (hn::Set(d, 10.0) - t * (hn::Set(d, 15.0) - hn::Set(d, 6.0) * t));
  const V fading = fade * away * away / (hn::Set(d, 1.0 - kParabola) * (one + away));
  return hn::IfThenElse(hn::Lt(away, hn::Set(d, kParabola)), one / (one - y * y), one + fading);
}

/// viaShift() of line_rest.h.
template <class D, class V>
HWY_INLINE Vector3<V> viaShiftOf(D d, const Vector3<V>& origin, const Vector3<V>& direction, const Vector3<V>& via,
                                 V tendon, V belly) {
  constexpr double kMostShift = 0.5;  // Of the belly's length.
  const V one = hn::Set(d, 1.0);
  const Vector3<V> there = via - origin;
  const V foot = dot(there, direction);
  const Vector3<V> beside = there - foot * direction;
  const V half = hn::Set(d, 0.5) * belly;
  const Vector3<V> shift = viaFactor(d, (foot - tendon - half) / half) * beside;
  const V length = lengthOf(shift);
  const V most = hn::Set(d, kMostShift) * belly;
  return hn::IfThenElse(hn::Gt(length, most), most / length, one) * shift;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
