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

#define formula HWY_INLINE
#include "core/geometry/formulas/potential.h"

#include "core/geometry/formulas/shape.h"

#include "core/geometry/formulas/bounds.h"
#undef formula

HWY_INLINE ShapeNumbers numbersOf(const UnitShape& unit) {
  return {all(unit.lateral), all(unit.taper),   all(unit.bend.x), all(unit.bend.y),
          all(unit.curve.x), all(unit.curve.y), all(unit.core),   all(unit.inverseEnd)};
}

/// A shaped primitive along the rays of the lanes from `first` on.
class ShapeOnRays {
 public:
  HWY_INLINE ShapeOnRays(const LaneShape& shape, std::size_t first) : shape_(shape), first_(first) {}

  HWY_INLINE V factor() const { return all(shape_.sense) * load(shape_.factor); }

  /// Where the rays are in the shape's box.
  HWY_INLINE Range box() const { return scaled(way(), {fromMiddle(shape_.enter), fromMiddle(shape_.leave)}); }

  /// The point at t.
  HWY_INLINE ShapePoint at(V t) const { return onLine(numbersOf(*shape_.unit), line(), lineAt(t)); }

  /// w and half the derivative of r^2.
  Sample sample(V t) const {
    const ShapeNumbers numbers = numbersOf(*shape_.unit);
    const ShapeLine on = line();
    const ShapePoint p = onLine(numbers, on, lineAt(t));
    return {hn::Max(zero(), all(1.0f) - shapeRSquared(p)), way() * dot(shapeHalfSlope(numbers, p), on.along)};
  }

  PotentialBounds bounds(V from, V to) const {
    const UnitShape& unit = *shape_.unit;
    const ShapeLine on = line();
    const bool backwards = shape_.way < 0.0f;
    const V s0 = clamp(lineAt(backwards ? to : from), on.enter, on.leave);
    const V s1 = clamp(lineAt(backwards ? from : to), on.enter, on.leave);
    return shapeBounds(numbersOf(unit), unit.curve != glm::vec2(0.0f), unit.taper != 0.0f, on, s0, s1, backwards);
  }

 private:
  HWY_INLINE V load(const LaneFloats& floats) const { return hn::Load(kTag, floats.at(first_)); }
  HWY_INLINE V way() const { return all(shape_.way); }
  HWY_INLINE V fromMiddle(const LaneFloats& s) const { return load(shape_.middle) + load(s); }
  HWY_INLINE V lineAt(V t) const { return way() * t - load(shape_.middle); }
  HWY_INLINE ShapeLine line() const {
    return {{load(shape_.point[0]), load(shape_.point[1]), load(shape_.point[2])},
            {load(shape_.along[0]), load(shape_.along[1]), load(shape_.along[2])},
            load(shape_.enter),
            load(shape_.leave),
            load(shape_.turnX),
            load(shape_.turnZ)};
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
  hn::Store(turnOf(yd.x, all(unit.curve.x), point.y, yd.y), kTag, out.turnX.at(first));
  hn::Store(turnOf(yd.z, all(unit.curve.y), point.y, yd.y), kTag, out.turnZ.at(first));
  return meets;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
