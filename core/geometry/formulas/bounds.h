// core/geometry/formulas/bounds.h: bounds of a potential and of its derivative on an interval of a ray.

/// Bounds of a number.
struct Range {
  Real low;
  Real high;
};

formula Range rangeOf(Real a, Real b) {
  Range range = {min(a, b), max(a, b)};
  return range;
}
formula Range sumOf(Range a, Range b) {
  Range range = {a.low + b.low, a.high + b.high};
  return range;
}
formula Range scaled(Real factor, Range range) { return rangeOf(factor * range.low, factor * range.high); }
formula Range productOf(Range a, Range b) {
  Range low = scaled(a.low, b);
  Range high = scaled(a.high, b);
  Range range = {min(low.low, high.low), max(low.high, high.high)};
  return range;
}
formula Range squareOf(Range range) {
  Range squares = rangeOf(range.low * range.low, range.high * range.high);
  Mask holdsZero = both(range.low <= num(0.0), range.high >= num(0.0));
  squares.low = select(holdsZero, num(0.0), squares.low);
  return squares;
}

/// Bounds of w = max(0, 1 - r^2). The derivative of r^2 is 2 rate times a number in `slope`.
struct PotentialBounds {
  Range w;
  Range slope;
  Real rate;
  Real atEnd;  ///< w at the interval's end.
};

/// Of an ellipsoid, w = peak - a d^2 from d0 to d1: concave, so least at an end, largest at an end or at the peak.
formula PotentialBounds ellipsoidBounds(Real a, Real peak, Real d0, Real d1) {
  Real w0 = max(num(0.0), peak - a * d0 * d0);
  Real w1 = max(num(0.0), peak - a * d1 * d1);
  Mask peaks = both(d0<num(0.0), d1> num(0.0));
  Range w = {min(w0, w1), select(peaks, max(num(0.0), peak), max(w0, w1))};
  Range slope = {d0, d1};
  PotentialBounds bounds = {w, slope, a, w1};
  return bounds;
}

/// A line through a shape's unit space, point + s along.
struct ShapeLine {
  Real3 point;
  Real3 along;
  Real enter;  ///< s in the shape's box, which holds all of it. Beyond it the point is held to the box.
  Real leave;
  Real turnX;  ///< s where the offsets from a bent axis have an extremum.
  Real turnZ;
};

formula ShapePoint onLine(ShapeNumbers shape, ShapeLine line, Real s) {
  return shapePoint(shape, line.point + clamp(s, line.enter, line.leave) * line.along);
}

/// s where x' = along - 2 curve (y + s dy) dy is 0.
formula Real turnOf(Real along, Real curve, Real y, Real dy) {
  Real far = num(1e30);
  Real twice = num(2.0) * curve * dy;
  Real bends = twice * dy;
  return select(bends == num(0.0), num(0.0), clamp((along - twice * y) / bends, num(0.0) - far, far));
}

/// Half the derivative of r^2 = S(y) (x^2 + z^2) + end^2 on [s0, s1], at whose ends the points are p0 and p1.
formula Range shapeSlopes(ShapeNumbers shape, bool bent, bool tapers, ShapeLine line, Real s0, Real s1, ShapePoint p0,
                          ShapePoint p1) {
  Real3 d = line.along;
  Real endRate = shape.inverseEnd * d.y;  // end grows with y: end dend/ds with s.
  Range ends = rangeOf(p0.end * endRate, p1.end * endRate);
  Range outward = rangeOf(p0.x * d.x + p0.z * d.z, p1.x * d.x + p1.z * d.z);  // Half the derivative of x^2 + z^2.
  if (!bent && !tapers) return sumOf(scaled(shape.lateral, outward), ends);
  Range x = rangeOf(p0.x, p1.x);
  Range z = rangeOf(p0.z, p1.z);
  if (bent) {
    Real atX = onLine(shape, line, clamp(line.turnX, s0, s1)).x;
    Real atZ = onLine(shape, line, clamp(line.turnZ, s0, s1)).z;
    x.low = min(x.low, atX);
    x.high = max(x.high, atX);
    z.low = min(z.low, atZ);
    z.high = max(z.high, atZ);
    Real curveX = num(2.0) * shape.curveX;
    Real curveZ = num(2.0) * shape.curveZ;
    outward = sumOf(productOf(x, rangeOf(d.x - curveX * p0.y * d.y, d.x - curveX * p1.y * d.y)),
                    productOf(z, rangeOf(d.z - curveZ * p0.y * d.y, d.z - curveZ * p1.y * d.y)));
  }
  Range sides = sumOf(productOf(rangeOf(p0.girth, p1.girth), outward), ends);
  if (!tapers) return sides;
  return sumOf(scaled(num(0.5) * shape.taper * d.y, sumOf(squareOf(x), squareOf(z))), sides);
}

/// Interval arithmetic bounds the derivative; r^2 then stays between the lines of least and of greatest slope through
/// its values at both ends. Interval arithmetic on r^2 itself would be looser by an order of the interval's length.
/// @param s0, s1  within the line's box.  @param backwards  the ray runs against the line: from s1 to s0.
formula PotentialBounds shapeBounds(ShapeNumbers shape, bool bent, bool tapers, ShapeLine line, Real s0, Real s1,
                                    bool backwards) {
  ShapePoint p0 = onLine(shape, line, s0);
  ShapePoint p1 = onLine(shape, line, s1);
  Range slope = shapeSlopes(shape, bent, tapers, line, s0, s1, p0, p1);
  Real r0 = shapeRSquared(p0);
  Real r1 = shapeRSquared(p1);
  Real extent = s1 - s0;
  Real least = slope.low + slope.low;
  Real most = slope.high + slope.high;
  Mask rises = least >= num(0.0);
  Mask falls = most <= num(0.0);
  Real spread = most - least;
  Real valley = clamp((r0 - r1 + most * extent) / spread, num(0.0), extent);
  Real summit = clamp((r1 - r0 - least * extent) / spread, num(0.0), extent);
  Real low = select(rises, r0, select(falls, r1, r0 + least * valley));
  Real high = select(rises, r1, select(falls, r0, r0 + most * summit));
  Range w = {max(num(0.0), num(1.0) - high), max(num(0.0), min(num(1.0), num(1.0) - low))};
  if (backwards) slope = scaled(num(-1.0), slope);
  PotentialBounds bounds = {w, slope, num(1.0), max(num(0.0), num(1.0) - (backwards ? r0 : r1))};
  return bounds;
}

/// Bounds of factor g on an interval.
struct TermBounds {
  Range value;
  Range slope;  ///< Of the derivative by t, divided by 4.
  Real atEnd;
  Real most;  ///< The largest magnitude of the value: it bounds rounding.
};

formula TermBounds termBounds(Real factor, PotentialBounds of) {
  Mask adds = factor >= num(0.0);
  Real atLow = potential(factor, of.w.low);
  Real atHigh = potential(factor, of.w.high);
  Real rate = factor * of.rate;  // The derivative is -4 factor rate slope dg/dw / 2.
  Real rateLow = potentialRate(of.w.low);
  Real rateHigh = potentialRate(of.w.high);
  Real minRise = rate * (min(of.slope.low, num(0.0)) * rateHigh + max(of.slope.low, num(0.0)) * rateLow);
  Real maxRise = rate * (max(of.slope.high, num(0.0)) * rateHigh + min(of.slope.high, num(0.0)) * rateLow);
  Range value = {select(adds, atLow, atHigh), select(adds, atHigh, atLow)};
  Range slope = {num(0.0) - select(adds, maxRise, minRise), num(0.0) - select(adds, minRise, maxRise)};
  TermBounds bounds = {value, slope, potential(factor, of.atEnd), abs(atHigh)};
  return bounds;
}
