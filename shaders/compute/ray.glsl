// shaders/compute/ray.glsl: the field along a ray, and a bracket around its first change of sign that rounding
// cannot have moved, in numbers of the type Real. As core/surface/roots/ray_lanes.h, one ray an invocation;
// docs/performance.md proves it. Needs field.glsl, shape.glsl, and of Real: kMostTerms, kMostShapes, kValueRounding,
// kSlopeRounding, kMostMarches, kMostSteps, kLeastStretch: what is shorter is a root or a touch.
const float kFar = 1e30;

struct Term {  // w(t) = peak - a (t - middle)^2, f(t) = factor max(0, w)^2.
  Real a, middle, peak, factor;
  uint slot;
  int shape;  // Index of the line through the shape that is meant instead; -1: an ellipsoid.
};
Term terms[kMostTerms];
int termCount;

struct ShapeLine {  // point + s along in the unit space, s = t - middle.
  int primitive;
  Real3 point, along;
  Real enter, leave;  // s in the shape's box; beyond it nothing of the shape is.
  Real turnX, turnZ;  // s where the offsets from a bent axis turn.
};
ShapeLine shapeLines[kMostShapes];
int shapeCount;

// psi = sense (skin + F - T).
Real sense, inverseWidth, maxFall;

Real skinFall(Real t) {
  Real u = t * inverseWidth;
  return min(u * (isoRadius + isoRadius + sense * u), maxFall);
}
Real skinRadius(Real t) { return max(Real(0.0), isoRadius + sense * (t * inverseWidth)); }
Real skinRoot(Real t) { return isoRoot - sense * skinFall(t); }
Real skinValue(Real t) {
  Real e = skinFall(t);
  return -e * (isoRoot + isoRoot - sense * e);
}

// Whether a ray may meet a ball ahead; rounding never says no where it does.
bool mayMeet(vec3 fromCenter, vec3 d, float radius) {
  float squared = dot(fromCenter, fromCenter);
  float along = dot(fromCenter, d);
  float within = 1.01 * radius * radius + 1e-5 * squared;
  return squared - along * along < within && (along < 0.0 || squared < within);
}

Real3 unitOf(Primitive p, Real3 d) {
  if (p.toUnit[2].w > 0.0) return d;
  return d.x * Real3(p.toUnit[0].xyz) + d.y * Real3(p.toUnit[1].xyz) + d.z * Real3(p.toUnit[2].xyz);
}

bool meetsShape;  // A ray may meet a muscle that is no ellipsoid.

// Narrows what of a line is in the box.
void clipTo(Real start, Real along, Real low, Real high, inout Real enter, inout Real leave) {
  Real divisor = abs(along) < 1e-20 ? Real(1e-20) : along;
  Real a = (low - start) / divisor, b = (high - start) / divisor;
  enter = max(enter, min(a, b));
  leave = min(leave, max(a, b));
}

// s where x' = along - 2 curve (y + s dy) dy = 0.
Real turnOf(Real along, Real curve, Real y, Real dy) {
  Real bends = 2.0 * curve * dy * dy;
  return bends == 0.0 ? Real(0.0) : clamp((along - 2.0 * curve * dy * y) / bends, Real(-kFar), Real(kFar));
}

// False: there are too many.
bool addShape(int primitive, Primitive p, Real3 y, Real3 yd, Real factor, uint slot) {
  ShapeLine line;
  line.primitive = primitive;
  Real middle = -dot(y, yd) / dot(yd, yd);
  line.point = y + middle * yd;
  line.along = yd;
  line.enter = Real(-kFar);
  line.leave = Real(kFar);
  clipTo(line.point.x, yd.x, p.low.x, p.high.x, line.enter, line.leave);
  clipTo(line.point.y, yd.y, p.low.y, p.high.y, line.enter, line.leave);
  clipTo(line.point.z, yd.z, p.low.z, p.high.z, line.enter, line.leave);
  if (!(line.enter < line.leave) || !(middle + line.leave > 0.0)) return true;
  if (termCount == kMostTerms || shapeCount == kMostShapes) return false;
  line.turnX = turnOf(yd.x, p.bendCurve.z, line.point.y, yd.y);
  line.turnZ = turnOf(yd.z, p.bendCurve.w, line.point.y, yd.y);
  terms[termCount++] = Term(Real(0.0), middle, Real(0.0), factor, slot, shapeCount);
  shapeLines[shapeCount++] = line;
  return true;
}

// False: there are too many.
bool fillTerms(vec3 from, vec3 d) {
  termCount = 0;
  shapeCount = 0;
  meetsShape = false;
  bool fits = true;
  for (int i = firstCandidate; i < endCandidate; ++i) {
    Candidate c = candidates[i];
    Primitive p = primitives[firstPrimitive + c.primitive];
    vec3 fromCenter = from - p.center.xyz;
    if (p.center.w == 0.0 || !mayMeet(fromCenter, d, p.center.w)) continue;
    float factor = strengthOf(p) * weightOf(c);
    if (factor == 0.0) continue;
    uint slot = factor < 0.0 ? kEverySum : c.slot;
    Real3 y = unitOf(p, Real3(fromCenter)), yd = unitOf(p, Real3(d));
    if (isShaped(p)) {
      meetsShape = true;
      fits = addShape(firstPrimitive + c.primitive, p, y, yd, sense * factor, slot) && fits;
      continue;
    }
    Real squared = dot(yd, yd);
    Real middle = -dot(y, yd) / squared;
    Real3 nearest = y + middle * yd;
    Real scale = scaleOf(p);
    Real peak = 1.0 - scale * dot(nearest, nearest);
    Real a = scale * squared;
    if (!(peak > 0.0) || !(middle > 0.0 || peak - a * middle * middle > 0.0)) continue;
    fits = fits && termCount < kMostTerms;
    if (fits) terms[termCount++] = Term(a, middle, peak, sense * factor, slot, -1);
  }
  return fits;
}

// The point of a line, held to the shape's box: beyond it r^2 is at least 1, as it is on its faces.
ShapePoint onLine(ShapeLine line, Real s) {
  return shapeAt(primitives[line.primitive], line.point + clamp(s, line.enter, line.leave) * line.along);
}

// w at t, and half the slope of r^2.
Real2 potentialAt(Term term, Real t) {
  Real d = t - term.middle;
  if (term.shape < 0) return Real2(max(Real(0.0), term.peak - term.a * d * d), term.a * d);
  ShapeLine line = shapeLines[term.shape];
  ShapePoint at = onLine(line, d);
  return Real2(max(Real(0.0), 1.0 - rSquaredOf(at)), dot(halfSlopeOf(primitives[line.primitive], at), line.along));
}

// psi and its slope.
Real2 sampleRay(Real t) {
  Real2 everywhere = Real2(0.0), best = Real2(0.0);
  for (int k = 0; k < cliqueCount; ++k) {
    uvec2 clique = cliqueAt(k);
    Real2 sum = Real2(0.0);
    for (int i = 0; i < termCount; ++i) {
      bool carves = terms[i].slot == kEverySum;
      if (carves ? k > 0 : !holds(clique, terms[i].slot)) continue;
      Real2 at = potentialAt(terms[i], t);
      Real2 part = terms[i].factor * at.x * at;
      if (carves) everywhere += part;
      else sum += part;
    }
    if (sense * sum.x > sense * best.x) best = sum;
  }
  Real2 field = everywhere + best;
  return Real2(skinValue(t) + field.x, -4.0 * (inverseWidth * skinRadius(t) * skinRoot(t) + field.y));
}

// What holds for w on a whole stretch. r^2 changes at 2 rate times a number between the slopes.
struct PotentialBounds {
  Real low, high;
  Real lowSlope, highSlope;
  Real rate;
  Real atEnd;
};

// w is concave: its least value is at an end, its largest at an end or at its peak.
PotentialBounds ellipsoidBounds(Term term, Real t0, Real t1) {
  Real d0 = t0 - term.middle, d1 = t1 - term.middle;
  Real w0 = max(Real(0.0), term.peak - term.a * d0 * d0), w1 = max(Real(0.0), term.peak - term.a * d1 * d1);
  Real most = d0 < 0.0 && d1 > 0.0 ? max(Real(0.0), term.peak) : max(w0, w1);
  return PotentialBounds(min(w0, w1), most, d0, d1, term.a, w1);
}

Real2 rangeOf(Real a, Real b) { return Real2(min(a, b), max(a, b)); }
Real2 productOf(Real2 a, Real2 b) {
  Real2 low = rangeOf(a.x * b.x, a.x * b.y), high = rangeOf(a.y * b.x, a.y * b.y);
  return Real2(min(low.x, high.x), max(low.y, high.y));
}
Real2 squareOf(Real2 r) {
  Real2 squares = rangeOf(r.x * r.x, r.y * r.y);
  if (r.x <= 0.0 && r.y >= 0.0) squares.x = Real(0.0);
  return squares;
}

// Half the slope of r^2 = S(y) (x^2 + z^2) + end^2 on [s0, s1].
Real2 shapeSlopes(Primitive p, ShapeLine line, Real s0, Real s1, ShapePoint p0, ShapePoint p1) {
  Real3 d = line.along;
  Real endRate = p.section.w * d.y;
  Real2 ends = rangeOf(p0.end * endRate, p1.end * endRate);
  Real2 x = rangeOf(p0.x, p1.x), z = rangeOf(p0.z, p1.z);
  Real2 outward = rangeOf(p0.x * d.x + p0.z * d.z, p1.x * d.x + p1.z * d.z);  // Half the slope of x^2 + z^2.
  if (p.bendCurve.z != 0.0 || p.bendCurve.w != 0.0) {
    Real atX = onLine(line, clamp(line.turnX, s0, s1)).x, atZ = onLine(line, clamp(line.turnZ, s0, s1)).z;
    x = Real2(min(x.x, atX), max(x.y, atX));
    z = Real2(min(z.x, atZ), max(z.y, atZ));
    Real curveX = 2.0 * p.bendCurve.z * d.y, curveZ = 2.0 * p.bendCurve.w * d.y;
    outward = productOf(x, rangeOf(d.x - curveX * p0.y, d.x - curveX * p1.y)) +
              productOf(z, rangeOf(d.z - curveZ * p0.y, d.z - curveZ * p1.y));
  }
  Real2 sides = productOf(rangeOf(p0.girth, p1.girth), outward) + ends;
  Real tapers = 0.5 * p.section.y * d.y;
  Real2 across = squareOf(x) + squareOf(z);
  return sides + rangeOf(tapers * across.x, tapers * across.y);
}

// Interval arithmetic on the slope; r^2 then stays between the lines of least and greatest slope through its ends.
PotentialBounds shapeBounds(Term term, Real t0, Real t1) {
  ShapeLine line = shapeLines[term.shape];
  Real s0 = clamp(t0 - term.middle, line.enter, line.leave), s1 = clamp(t1 - term.middle, line.enter, line.leave);
  ShapePoint p0 = onLine(line, s0), p1 = onLine(line, s1);
  Real2 slope = shapeSlopes(primitives[line.primitive], line, s0, s1, p0, p1);
  Real r0 = rSquaredOf(p0), r1 = rSquaredOf(p1);
  Real length = s1 - s0, least = slope.x + slope.x, most = slope.y + slope.y, spread = most - least;
  Real low = min(r0, r1), high = max(r0, r1);
  if (least < 0.0 && most > 0.0) {
    low = r0 + least * clamp((r0 - r1 + most * length) / spread, Real(0.0), length);
    high = r0 + most * clamp((r1 - r0 - least * length) / spread, Real(0.0), length);
  }
  return PotentialBounds(max(Real(0.0), 1.0 - high), max(Real(0.0), min(Real(1.0), 1.0 - low)), slope.x, slope.y,
                         Real(1.0), max(Real(0.0), 1.0 - r1));
}

struct Bounds {
  Real value;     // psi is nowhere less ...
  Real maxSlope;  // ... and its slope nowhere more ...
  Real minSlope;  // ... and nowhere less.
  Real values;    // Sums of the magnitudes that went into them: what rounding is measured by.
  Real slopes;
  Real atEnd;
};

Bounds boundsOf(Real t0, Real t1) {
  Bounds all;  // Of carves; magnitudes of everything.
  all.value = all.maxSlope = all.minSlope = all.values = all.slopes = all.atEnd = Real(0.0);
  Real value = Real(-kFar), atEnd = Real(-kFar), maxSlope = Real(-kFar), minSlope = Real(kFar);
  for (int k = 0; k < cliqueCount; ++k) {
    uvec2 clique = cliqueAt(k);
    Real sumLow = Real(0.0), sumEnd = Real(0.0), sumMax = Real(0.0), sumMin = Real(0.0);
    for (int i = 0; i < termCount; ++i) {
      bool carves = terms[i].slot == kEverySum;
      if (k > 0 && (carves || !holds(clique, terms[i].slot))) continue;
      PotentialBounds w;
      if (terms[i].shape < 0) w = ellipsoidBounds(terms[i], t0, t1);
      else w = shapeBounds(terms[i], t0, t1);
      Real factor = terms[i].factor;
      Real atLow = factor * w.low * w.low, atHigh = factor * w.high * w.high;
      Real rate = factor * w.rate;
      Real minDw = rate * (min(w.lowSlope, Real(0.0)) * w.high + max(w.lowSlope, Real(0.0)) * w.low);
      Real maxDw = rate * (max(w.highSlope, Real(0.0)) * w.high + min(w.highSlope, Real(0.0)) * w.low);
      bool adds = factor >= 0.0;
      Real least = adds ? atLow : atHigh;
      Real most = -(adds ? minDw : maxDw), fewest = -(adds ? maxDw : minDw);
      Real end = factor * w.atEnd * w.atEnd;
      if (k == 0) {
        all.values += abs(atHigh);
        all.slopes += max(abs(most), abs(fewest));
      }
      if (carves) {
        all.value += least;
        all.atEnd += end;
        all.maxSlope += most;
        all.minSlope += fewest;
      } else if (holds(clique, terms[i].slot)) {
        sumLow += least;
        sumEnd += end;
        sumMax += most;
        sumMin += fewest;
      }
    }
    value = max(value, sense * sumLow);
    atEnd = max(atEnd, sense * sumEnd);
    maxSlope = max(maxSlope, sumMax);
    minSlope = min(minSlope, sumMin);
  }
  Real skin = skinValue(t1);
  Bounds psi = Bounds(skin + all.value + sense * value, all.maxSlope + maxSlope, all.minSlope + minSlope,
                      all.values + abs(skin), all.slopes, skin + all.atEnd + sense * atEnd);
  Real2 radius = rangeOf(skinRadius(t0), skinRadius(t1)), root = rangeOf(skinRoot(t0), skinRoot(t1));
  Real fall = inverseWidth * radius.y * root.y;
  psi.maxSlope -= inverseWidth * radius.x * root.x;
  psi.minSlope -= fall;
  psi.slopes += fall;
  psi.maxSlope *= 4.0;
  psi.minSlope *= 4.0;
  psi.slopes *= 4.0;
  return psi;
}

// Where terms may rise, from and to, and the end of the search. @param width  over which the skin blends
Real3 riseOf(Real width) {
  bool outward = sense > 0.0;
  Real3 rise = Real3(Real(kFar), Real(0.0), outward ? width : isoRadius / inverseWidth);
  for (int i = 0; i < termCount; ++i) {
    Real middle = terms[i].middle;
    Real2 extent, rising;  // A shape's w rises anywhere in its box.
    if (terms[i].shape < 0) {
      Real reach = sqrt(max(Real(0.0), terms[i].peak) / terms[i].a);
      extent = Real2(middle - reach, middle + reach);
      rising = terms[i].factor > 0.0 ? Real2(extent.x, middle) : Real2(middle, extent.y);
    } else {
      rising = extent = middle + Real2(shapeLines[terms[i].shape].enter, shapeLines[terms[i].shape].leave);
    }
    if (outward) rise.z = max(rise.z, extent.y);
    if (!(rising.y > 0.0)) continue;
    rise.x = min(rise.x, max(Real(0.0), rising.x));
    rise.y = max(rise.y, rising.y);
  }
  return rise;
}

// How far a search has come: psi > 0 up to low, and a root lies before high in a stretch where psi only falls.
struct Search {
  Real low, high;
  bool bracketed, rootless;
};

// From low to `end`, stretch after stretch, the first up to high. psi only falls from `to` on.
void march(Real to, Real end, bool endsBelow, int stretches, inout Search search) {
  Real low = search.low, high = search.high;
  for (int i = 0; i < stretches; ++i) {
    Bounds bounds = boundsOf(low, high);
    Real enough = kSlopeRounding * bounds.slopes;
    bool falls = bounds.maxSlope <= -enough;
    if (falls && bounds.atEnd <= 0.0) {
      search = Search(low, high, true, false);
      return;
    }
    Real stretch = high - low;
    if (stretch <= kLeastStretch && sampleRay(high).x <= 0.0) {
      search = Search(low, high, true, false);
      return;
    }
    bool clear = bounds.value > kValueRounding * bounds.values;
    bool passes = clear || bounds.minSlope >= enough || (falls && bounds.atEnd > 0.0);
    if (stretch > kLeastStretch && !passes) {
      high = low + 0.5 * stretch;
      continue;
    }
    low = high;
    high = low < to ? min(low + stretch + stretch, to) : end;
    if (low < to) continue;
    if (low >= end) {
      search.rootless = true;
      return;
    }
    if (endsBelow) {
      search = Search(low, high, true, false);
      return;
    }
  }
  search.low = low;
}

// From the skin, psi = 0 and falling. psi might rise from rise.x to rise.y; the search ends at rise.z.
Search bracketFromSkin(Real3 rise) {
  bool outward = sense > 0.0;
  bool falls = rise.x >= rise.z;
  Real from = min(rise.x, rise.z);
  Search search = Search(Real(0.0), from, falls && outward, false);
  if (search.bracketed) return search;
  if (sampleRay(from).x <= 0.0) {
    search.bracketed = true;
    return search;
  }
  search.rootless = falls;
  if (falls) return search;
  Real to = min(rise.y, rise.z);
  search.low = from;
  search.high = to;
  march(to, rise.z, outward, kMostMarches, search);
  return search;
}

// Newton's steps kept inside the bracket, which is halved now and then: on a bent slope they may go to and fro for
// ever.
// False: rounding may have moved the root.
bool newton(Search search, out Real root) {
  Real low = search.low, high = search.high;
  root = search.low;
  bool open = true, steep = false;
  for (int i = 0; i < kMostSteps && open; ++i) {
    Real2 at = sampleRay(root);
    low = at.x > 0.0 ? root : low;
    high = at.x > 0.0 ? high : root;
    Real next = root - at.x / at.y;
    bool halves = (i > 7 && i % 4 == 3) || !(next >= low && next <= high);
    next = halves ? 0.5 * (low + high) : next;
    open = abs(next - root) > tolerance;
    steep = at.y <= -5e-8 / tolerance;
    root = next;
  }
  return !open && steep;
}
