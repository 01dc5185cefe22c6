// core/surface/roots/shape_lanes.h: r^2 of capsules, eggs and bent spindles in lanes: at points, along lines, and its
// bounds on intervals of lines. Included once per instruction set.
#if defined(SINEW_SHAPE_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_SHAPE_LANES_H
#undef SINEW_SHAPE_LANES_H
#else
#define SINEW_SHAPE_LANES_H
#endif

#include "core/geometry/lanes.h"
#include "core/surface/roots/lane_terms.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Bounds of a value, by lane.
struct Range {
  V low;
  V high;

  friend HWY_INLINE Range operator+(const Range& a, const Range& b) { return {a.low + b.low, a.high + b.high}; }
  friend HWY_INLINE Range operator*(V s, const Range& r) {
    return {hn::Min(s * r.low, s * r.high), hn::Max(s * r.low, s * r.high)};
  }
};

HWY_INLINE Range rangeOf(V a, V b) { return {hn::Min(a, b), hn::Max(a, b)}; }
HWY_INLINE Range operator*(const Range& a, const Range& b) {
  const Range low = a.low * b;
  const Range high = a.high * b;
  return {hn::Min(low.low, high.low), hn::Max(low.high, high.high)};
}
HWY_INLINE Range squareOf(const Range& r) {
  const Range squares = rangeOf(r.low * r.low, r.high * r.high);
  const M holdsZero = both(hn::Le(r.low, zero()), hn::Ge(r.high, zero()));
  return {select(holdsZero, zero(), squares.low), squares.high};
}
HWY_INLINE V clamped(V x, V low, V high) { return hn::Min(hn::Max(x, low), high); }

/// Parts of UnitShape's formula at one point, for r^2 and its derivative.
struct ShapePoint {
  const UnitShape& unit;
  V y;
  V x;  ///< From the axis, which may be bent.
  V z;
  V girth;  ///< nu S(y)
  V end;    ///< Distance beyond the core over the end's length, signed like y.

  HWY_INLINE ShapePoint(const UnitShape& shape, const V3& p)
      : unit(shape),
        y(p.y),
        x(p.x - all(shape.bend.x) - all(shape.curve.x) * y * y),
        z(p.z - all(shape.bend.y) - all(shape.curve.y) * y * y),
        girth(all(shape.lateral) + all(shape.taper) * y),
        end((y - clamped(y, all(-shape.core), all(shape.core))) * all(shape.inverseEnd)) {}

  HWY_INLINE V across() const { return x * x + z * z; }
  HWY_INLINE V rSquared() const {
    const V ends = end * end;
    return select(hn::Lt(ends, all(1.0f)), girth * across() + ends, ends);  // S may be negative beyond.
  }
  /// Half of d(r^2)/dp.
  HWY_INLINE V3 halfSlope() const {
    const V gx = girth * x;
    const V gz = girth * z;
    const V axis = all(0.5f * unit.taper) * across() - (y + y) * (all(unit.curve.x) * gx + all(unit.curve.y) * gz) +
                   end * all(unit.inverseEnd);
    return {gx, axis, gz};
  }
};

/// Bounds of w = max(0, 1 - r^2) on an interval of every ray. The derivative of r^2 is 2 rate times a number in
/// `slope`.
struct PotentialBounds {
  Range w;
  Range slope;
  V rate;
  V atEnd;  ///< w at the interval's end.
};

/// A shaped primitive along the rays of the lanes from `first` on.
class ShapeOnRays {
 public:
  HWY_INLINE ShapeOnRays(const LaneShape& shape, std::size_t first) : shape_(shape), first_(first) {}

  HWY_INLINE V factor() const { return all(shape_.sense) * load(shape_.factor); }

  /// Where the rays are in the shape's box.
  HWY_INLINE Range box() const { return way() * Range{fromMiddle(shape_.enter), fromMiddle(shape_.leave)}; }

  /// The point at t, clamped to the box: r^2 is at least 1 on its faces and beyond.
  HWY_INLINE ShapePoint at(V t) const { return pointAt(lineAt(t), along()); }

  struct Sample {
    V w;
    V halfSlope;  ///< Half the derivative of r^2.
  };

  Sample sample(V t) const {
    const V3 d = along();
    const ShapePoint p = pointAt(lineAt(t), d);
    return {hn::Max(zero(), all(1.0f) - p.rSquared()), way() * dot(p.halfSlope(), d)};
  }

  /// Interval arithmetic bounds the derivative; r^2 then stays between the lines of least and of greatest slope through
  /// its values at both ends. Interval arithmetic on r^2 itself would be looser by an order of the interval's length.
  PotentialBounds bounds(V from, V to) const {
    const bool runsAlong = shape_.way > 0.0f;
    const V s0 = held(lineAt(runsAlong ? from : to));
    const V s1 = held(lineAt(runsAlong ? to : from));
    const V3 d = along();
    const ShapePoint p0 = pointAt(s0, d);
    const ShapePoint p1 = pointAt(s1, d);
    const Range slope = slopes(s0, s1, p0, p1, d);
    const V r0 = p0.rSquared();
    const V r1 = p1.rSquared();
    const V length = s1 - s0;
    const V min = slope.low + slope.low;
    const V max = slope.high + slope.high;
    const M rises = hn::Ge(min, zero());
    const M falls = hn::Le(max, zero());
    const V spread = max - min;
    const V valley = clamped((r0 - r1 + max * length) / spread, zero(), length);
    const V summit = clamped((r1 - r0 - min * length) / spread, zero(), length);
    const V low = select(rises, r0, select(falls, r1, r0 + min * valley));
    const V high = select(rises, r1, select(falls, r0, r0 + max * summit));
    const V one = all(1.0f);
    return {{hn::Max(zero(), one - high), hn::Max(zero(), hn::Min(one, one - low))},
            way() * slope,
            one,
            hn::Max(zero(), one - (runsAlong ? r1 : r0))};
  }

 private:
  HWY_INLINE V load(const LaneFloats& floats) const { return hn::Load(kTag, floats.at(first_)); }
  HWY_INLINE V way() const { return all(shape_.way); }
  HWY_INLINE V fromMiddle(const LaneFloats& s) const { return load(shape_.middle) + load(s); }
  HWY_INLINE V lineAt(V t) const { return way() * t - load(shape_.middle); }
  HWY_INLINE V3 along() const { return {load(shape_.along[0]), load(shape_.along[1]), load(shape_.along[2])}; }
  HWY_INLINE V held(V s) const { return clamped(s, load(shape_.enter), load(shape_.leave)); }
  HWY_INLINE ShapePoint pointAt(V s, const V3& d) const {
    const V3 point{load(shape_.point[0]), load(shape_.point[1]), load(shape_.point[2])};
    return {*shape_.unit, point + held(s) * d};
  }

  /// Half the derivative of r^2 = S(y) (x^2 + z^2) + end^2 on [s0, s1].
  Range slopes(V s0, V s1, const ShapePoint& p0, const ShapePoint& p1, const V3& d) const {
    const UnitShape& unit = *shape_.unit;
    const V endRate = all(unit.inverseEnd) * d.y;  // end grows with y: end dend/ds with s.
    const Range ends = rangeOf(p0.end * endRate, p1.end * endRate);
    const bool bent = unit.curve != glm::vec2(0.0f);
    if (!bent && unit.taper == 0.0f) {
      const V g = all(unit.lateral);
      return rangeOf(g * (p0.x * d.x + p0.z * d.z), g * (p1.x * d.x + p1.z * d.z)) + ends;
    }
    Range x = rangeOf(p0.x, p1.x);
    Range z = rangeOf(p0.z, p1.z);
    Range outward = rangeOf(p0.x * d.x + p0.z * d.z, p1.x * d.x + p1.z * d.z);  // Half the derivative of x^2 + z^2.
    if (bent) {
      const V atX = pointAt(clamped(load(shape_.turnX), s0, s1), d).x;
      const V atZ = pointAt(clamped(load(shape_.turnZ), s0, s1), d).z;
      x = {hn::Min(x.low, atX), hn::Max(x.high, atX)};
      z = {hn::Min(z.low, atZ), hn::Max(z.high, atZ)};
      const auto rate = [&](V alongAxis, float curve, const ShapePoint& p)
                            HWY_ATTR { return alongAxis - all(2.0f * curve) * p.y * d.y; };
      outward = x * rangeOf(rate(d.x, unit.curve.x, p0), rate(d.x, unit.curve.x, p1)) +
                z * rangeOf(rate(d.z, unit.curve.y, p0), rate(d.z, unit.curve.y, p1));
    }
    const Range girth = rangeOf(p0.girth, p1.girth);
    const Range sides = girth * outward + ends;
    if (unit.taper == 0.0f) return sides;
    return (all(0.5f * unit.taper) * d.y) * (squareOf(x) + squareOf(z)) + sides;
  }

  const LaneShape& shape_;
  std::size_t first_;
};

/// Intersects lines p + t d with a shape. Fills all but factor, primitive and slot.  @return lanes that meet its box.
/// @param y, yd  p minus the shape's center, and d, in its unit space.
inline M fillShape(const UnitShape& unit, const V3& y, const V3& yd, std::size_t first, LaneShape& out) {
  const V middle = zero() - dot(y, yd) / dot(yd, yd);
  const V3 point = y + middle * yd;
  out.unit = &unit;
  out.way = out.sense = 1.0f;
  hn::Store(middle, kTag, out.middle.at(first));
  const V far = all(1e30f);
  Range inside{zero() - far, far};
  const auto clip = [&](V start, V along, float low, float high, std::size_t axis) HWY_ATTR {
    hn::Store(start, kTag, out.point[axis].at(first));
    hn::Store(along, kTag, out.along[axis].at(first));
    const V tiny = all(1e-20f);
    const V divisor = select(hn::Lt(hn::Abs(along), tiny), tiny, along);
    const Range slab = rangeOf((all(low) - start) / divisor, (all(high) - start) / divisor);
    inside = {hn::Max(inside.low, slab.low), hn::Min(inside.high, slab.high)};
  };
  clip(point.x, yd.x, unit.low.x, unit.high.x, 0);
  clip(point.y, yd.y, unit.low.y, unit.high.y, 1);
  clip(point.z, yd.z, unit.low.z, unit.high.z, 2);
  const M meets = hn::Lt(inside.low, inside.high);
  hn::Store(select(meets, inside.low, zero()), kTag, out.enter.at(first));
  hn::Store(select(meets, inside.high, zero()), kTag, out.leave.at(first));
  // x' = dx - 2 curve (y + s dy) dy = 0
  const auto turn = [&](V along, float curve, LaneFloats& to) HWY_ATTR {
    const V twice = all(2.0f * curve) * yd.y;
    const V bends = twice * yd.y;
    const V at = (along - twice * point.y) / bends;
    hn::Store(select(hn::Eq(bends, zero()), zero(), clamped(at, zero() - far, far)), kTag, to.at(first));
  };
  turn(yd.x, unit.curve.x, out.turnX);
  turn(yd.z, unit.curve.y, out.turnZ);
  return meets;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
