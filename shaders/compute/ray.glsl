// shaders/compute/ray.glsl: the field along a ray, and a bracket around its first change of sign that rounding
// cannot have moved, in numbers of the type Real. As core/surface/roots/ray_lanes.h, one ray an invocation;
// docs/performance.md proves it. Needs field.glsl, shape.glsl, blend.glsl, formulas up to bounds.h, and of Real: kMostTerms,
// kMostShapes, kValueRounding, kSlopeRounding, kMostMarches, kMostSteps, kLeastStretch: what is shorter is a root or a
// touch.
const float kFar = 1e30;

struct Term {  // w(t) = peak - a (t - middle)^2, f(t) = factor g.
  Real a, middle, peak, factor;
  float groove;
  uint slot;
  int shape;  // Index of the line through the shape that is meant instead; -1: an ellipsoid.
};
Term terms[kMostTerms];
int termCount;

ShapeLine shapeLines[kMostShapes];
int shapePrimitives[kMostShapes];
int shapeCount;

// psi = skin.sense (skin + F - T).
SkinRay skin;

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

// False: there are too many.
bool addShape(int primitive, Primitive p, Real3 y, Real3 yd, Real factor, uint slot) {
  Real middle = -dot(y, yd) / dot(yd, yd);
  ShapeLine line = ShapeLine(y + middle * yd, yd, Real(-kFar), Real(kFar), Real(0.0), Real(0.0));
  clipTo(line.point.x, yd.x, p.low.x, p.high.x, line.enter, line.leave);
  clipTo(line.point.y, yd.y, p.low.y, p.high.y, line.enter, line.leave);
  clipTo(line.point.z, yd.z, p.low.z, p.high.z, line.enter, line.leave);
  if (!(line.enter < line.leave) || !(middle + line.leave > 0.0)) return true;
  if (termCount == kMostTerms || shapeCount == kMostShapes) return false;
  line.turnX = turnOf(yd.x, p.bendCurve.z, line.point.y, yd.y);
  line.turnZ = turnOf(yd.z, p.bendCurve.w, line.point.y, yd.y);
  terms[termCount++] = Term(Real(0.0), middle, Real(0.0), factor, grooveOf(p), slot, shapeCount);
  shapePrimitives[shapeCount] = primitive;
  shapeLines[shapeCount++] = line;
  return true;
}

void blendTerms() {
  uvec2 slots = uvec2(0u);
  for (int i = 0; i < termCount; ++i) slots |= terms[i].slot == kEverySum ? uvec2(0u) : setOf(terms[i].slot);
  blendAmong(slots);
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
      fits = addShape(firstPrimitive + c.primitive, p, y, yd, skin.sense * factor, slot) && fits;
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
    if (fits) terms[termCount++] = Term(a, middle, peak, skin.sense * factor, grooveOf(p), slot, -1);
  }
  if (softGrooves) blendTerms();
  return fits;
}

// w at t, and half the slope of r^2.
Sample potentialAt(Term term, Real t) {
  Real d = t - term.middle;
  if (term.shape < 0) return Sample(max(Real(0.0), term.peak - term.a * d * d), term.a * d);
  ShapeLine line = shapeLines[term.shape];
  ShapeNumbers shape = numbersOf(primitives[shapePrimitives[term.shape]]);
  ShapePoint at = onLine(shape, line, d);
  return Sample(max(Real(0.0), 1.0 - shapeRSquared(at)), dot(shapeHalfSlope(shape, at), line.along));
}

// With soft grooves.
Sample sampleSoftRay(Real t) {
  Real slopes[kMostTerms];
  Sample psi = Sample(skinValue(skin, t), skinSlope(skin, t));
  clearGroups();
  for (int i = 0; i < termCount; ++i) {
    Sample at = potentialAt(terms[i], t);
    Real value = potential(terms[i].factor, at.value);
    slopes[i] = terms[i].factor * potentialRate(at.value) * at.slope;
    if (terms[i].slot == kEverySum) psi.value += value;
    else if (at.value > 0.0) addToGroup(terms[i].slot, skin.sense * value, terms[i].groove);
  }
  psi.value += skin.sense * settleGroups();
  for (int i = 0; i < termCount; ++i) {
    if (terms[i].slot == kEverySum) psi.slope += slopes[i];
    else if (slopes[i] != 0.0) psi.slope += slopes[i] * countedOf(terms[i].slot, terms[i].groove);
  }
  psi.slope *= -4.0;
  return psi;
}

// psi and its slope.
Sample sampleRay(Real t) {
  if (softGrooves) return sampleSoftRay(t);
  Sample everywhere = Sample(Real(0.0), Real(0.0));
  for (int level = 0, k = 0; level < levelsSeen; ++level) {
    Sample best = Sample(Real(0.0), Real(0.0));
    for (; k < levelEnd(level); ++k) {
      uvec2 clique = cliqueAt(k);
      Sample sum = Sample(Real(0.0), Real(0.0));
      for (int i = 0; i < termCount; ++i) {
        bool carves = terms[i].slot == kEverySum;
        if (carves ? k > 0 : !holds(clique, terms[i].slot)) continue;
        Sample at = potentialAt(terms[i], t);
        Real value = potential(terms[i].factor, at.value);
        Real slope = terms[i].factor * potentialRate(at.value) * at.slope;
        if (carves) everywhere = Sample(everywhere.value + value, everywhere.slope + slope);
        else sum = Sample(sum.value + value, sum.slope + slope);
      }
      if (skin.sense * sum.value > skin.sense * best.value) best = sum;
    }
    Real weight = Real(levelWeight(level));
    everywhere = Sample(everywhere.value + weight * best.value, everywhere.slope + weight * best.slope);
  }
  return Sample(skinValue(skin, t) + everywhere.value, -4.0 * (skinSlope(skin, t) + everywhere.slope));
}

PotentialBounds boundsOf(Term term, Real t0, Real t1) {
  Real d0 = t0 - term.middle, d1 = t1 - term.middle;
  if (term.shape < 0) return ellipsoidBounds(term.a, term.peak, d0, d1);
  ShapeLine line = shapeLines[term.shape];
  Primitive p = primitives[shapePrimitives[term.shape]];
  return shapeBounds(numbersOf(p), isBent(p), tapers(p), line, clamp(d0, line.enter, line.leave),
                     clamp(d1, line.enter, line.leave), false);
}

struct Bounds {
  Real value;     // psi is nowhere less ...
  Real maxSlope;  // ... and its slope nowhere more ...
  Real minSlope;  // ... and nowhere less.
  Real values;    // Sums of the magnitudes that went into them: what rounding is measured by.
  Real slopes;
  Real atEnd;
};

// Of the terms, slopes divided by 4: those that count everywhere, with the magnitudes of all, and what the cliques make
// of theirs.
struct TermSums {
  Bounds everywhere;
  Bounds together;
};

const Bounds kNoBounds = Bounds(Real(0.0), Real(0.0), Real(0.0), Real(0.0), Real(0.0), Real(0.0));

void addLevel(int level, Bounds of, inout Bounds together) {
  Real weight = Real(levelWeight(level));
  together.value += weight * of.value;
  together.maxSlope += weight * of.maxSlope;
  together.minSlope += weight * of.minSlope;
  together.atEnd += weight * of.atEnd;
}

TermSums crispSumsOf(Real t0, Real t1) {
  TermSums sums;
  sums.everywhere = sums.together = kNoBounds;
  for (int level = 0, k = 0; level < levelsSeen; ++level) {
    Real value = Real(-kFar), atEnd = Real(-kFar), maxSlope = Real(-kFar), minSlope = Real(kFar);
    for (; k < levelEnd(level); ++k) {
      uvec2 clique = cliqueAt(k);
      Real sumLow = Real(0.0), sumEnd = Real(0.0), sumMax = Real(0.0), sumMin = Real(0.0);
      for (int i = 0; i < termCount; ++i) {
        bool carves = terms[i].slot == kEverySum;
        if (k > 0 && (carves || !holds(clique, terms[i].slot))) continue;
        TermBounds term = termBounds(terms[i].factor, boundsOf(terms[i], t0, t1));
        if (k == 0) {
          sums.everywhere.values += term.most;
          sums.everywhere.slopes += max(abs(term.slope.high), abs(term.slope.low));
        }
        if (carves) {
          sums.everywhere.value += term.value.low;
          sums.everywhere.atEnd += term.atEnd;
          sums.everywhere.maxSlope += term.slope.high;
          sums.everywhere.minSlope += term.slope.low;
        } else if (holds(clique, terms[i].slot)) {
          sumLow += term.value.low;
          sumEnd += term.atEnd;
          sumMax += term.slope.high;
          sumMin += term.slope.low;
        }
      }
      value = max(value, skin.sense * sumLow);
      atEnd = max(atEnd, skin.sense * sumEnd);
      maxSlope = max(maxSlope, sumMax);
      minSlope = min(minSlope, sumMin);
    }
    addLevel(level, Bounds(skin.sense * value, maxSlope, minSlope, Real(0.0), Real(0.0), skin.sense * atEnd),
             sums.together);
  }
  return sums;
}

// In the level in use F is the largest of the cliques' sums, and with soft grooves up to sum y_j / 8 more: only those
// that may be the largest somewhere bound the slope.
Bounds softlyTogether(TermBounds own[kMostTerms]) {
  bool outward = skin.sense > 0.0;
  Real surely = Real(-kFar), value = surely, atEnd = surely;  // F is nowhere less than `surely`.
  for (int k = 0; k < blendedCount; ++k) {
    uvec2 clique = blended(k);
    Real low = Real(0.0), high = Real(0.0), end = Real(0.0), softest = Real(0.0);
    for (int i = 0; i < termCount; ++i) {
      if (terms[i].slot == kEverySum || !holds(clique, terms[i].slot)) continue;
      low += own[i].value.low;
      high += own[i].value.high;
      end += own[i].atEnd;
      softest += terms[i].groove * own[i].most;
    }
    surely = max(surely, (outward ? low : -high) - 0.5 * softest);
    value = max(value, skin.sense * low);
    atEnd = max(atEnd, skin.sense * end);
  }
  Real maxSlope = Real(-kFar), minSlope = Real(kFar);
  int mayWin = 0;
  for (int k = 0; k < blendedCount; ++k) {
    uvec2 clique = blended(k);
    Real most = Real(0.0), softest = Real(0.0), sumMax = Real(0.0), sumMin = Real(0.0);
    for (int i = 0; i < termCount; ++i) {
      if (terms[i].slot == kEverySum || !holds(clique, terms[i].slot)) continue;
      most += outward ? own[i].value.high : -own[i].value.low;
      softest += terms[i].groove * own[i].most;
      sumMax += own[i].slope.high;
      sumMin += own[i].slope.low;
    }
    if (most + 0.5 * softest < surely) continue;
    ++mayWin;
    maxSlope = max(maxSlope, sumMax);
    minSlope = min(minSlope, sumMin);
  }
  if (mayWin > 1) {
    clearGroups();
    for (int i = 0; i < termCount; ++i) {
      if (terms[i].slot == kEverySum) continue;
      if (own[i].atEnd != 0.0) addToGroup(terms[i].slot, skin.sense * own[i].atEnd, terms[i].groove);
      if (!outward) value += 0.125 * terms[i].groove * own[i].most;
    }
    atEnd = settleLevel();
    for (uvec2 slots = blendedSlots; holdsAny(slots);) {
      uint slot = uint(takeSlot(slots));
      Real rise = Real(0.0), fall = Real(0.0);
      for (int i = 0; i < termCount; ++i) {
        if (terms[i].slot != slot) continue;
        rise += terms[i].groove * own[i].slope.high;
        fall += terms[i].groove * own[i].slope.low;
      }
      maxSlope += 0.125 * max(Real(0.0), rise);
      minSlope += 0.125 * min(Real(0.0), fall);
    }
  }
  return Bounds(skin.sense * value, maxSlope, minSlope, Real(0.0), Real(0.0), skin.sense * atEnd);
}

TermSums softSumsOf(Real t0, Real t1) {
  TermBounds own[kMostTerms];
  Bounds all = kNoBounds;
  for (int i = 0; i < termCount; ++i) {
    own[i] = termBounds(terms[i].factor, boundsOf(terms[i], t0, t1));
    all.values += own[i].most;
    all.slopes += max(abs(own[i].slope.high), abs(own[i].slope.low));
    if (terms[i].slot != kEverySum) continue;
    all.value += own[i].value.low;
    all.atEnd += own[i].atEnd;
    all.maxSlope += own[i].slope.high;
    all.minSlope += own[i].slope.low;
  }
  Bounds together = kNoBounds;
  for (int level = 0; level < levelsSeen; ++level) {
    useLevel(level);
    addLevel(level, softlyTogether(own), together);
  }
  return TermSums(all, together);
}

Bounds boundsOf(Real t0, Real t1) {
  TermSums sums;
  if (softGrooves) sums = softSumsOf(t0, t1);
  else sums = crispSumsOf(t0, t1);
  Bounds all = sums.everywhere, together = sums.together;
  Real ofSkin = skinValue(skin, t1);
  Bounds psi = Bounds(ofSkin + all.value + together.value, all.maxSlope + together.maxSlope,
                      all.minSlope + together.minSlope, all.values + abs(ofSkin), all.slopes,
                      ofSkin + all.atEnd + together.atEnd);
  Range radius = rangeOf(skinRadius(skin, t0), skinRadius(skin, t1));
  Range rate = rangeOf(skinRate(skin, t0), skinRate(skin, t1));
  Real fall = skin.inverseWidth * radius.high * rate.high;
  psi.maxSlope -= skin.inverseWidth * radius.low * rate.low;
  psi.minSlope -= fall;
  psi.slopes += fall;
  psi.maxSlope *= 4.0;
  psi.minSlope *= 4.0;
  psi.slopes *= 4.0;
  return psi;
}

// Where terms may rise, from and to, and the end of the search. @param width  over which the skin blends
Real3 riseOf(Real width) {
  bool outward = skin.sense > 0.0;
  Real3 rise = Real3(Real(kFar), Real(0.0), outward ? width : isoRadius / skin.inverseWidth);
  for (int i = 0; i < termCount; ++i) {
    Real middle = terms[i].middle;
    Range extent, rising;  // A shape's w rises anywhere in its box.
    if (terms[i].shape < 0) {
      Real reach = sqrt(max(Real(0.0), terms[i].peak) / terms[i].a);
      extent = Range(middle - reach, middle + reach);
      rising = Range(terms[i].factor > 0.0 ? extent.low : middle, terms[i].factor > 0.0 ? middle : extent.high);
    } else {
      ShapeLine line = shapeLines[terms[i].shape];
      rising = extent = Range(middle + line.enter, middle + line.leave);
    }
    if (outward) rise.z = max(rise.z, extent.high);
    if (!(rising.high > 0.0)) continue;
    rise.x = min(rise.x, max(Real(0.0), rising.low));
    rise.y = max(rise.y, rising.high);
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
    if (stretch <= kLeastStretch && sampleRay(high).value <= 0.0) {
      search = Search(low, high, true, false);
      return;
    }
    // With soft grooves the bound of the value alone does not become tight where stretches get short.
    Real least = bounds.value;
    if (softGrooves) least = max(least, bounds.atEnd - max(Real(0.0), bounds.maxSlope) * stretch);
    bool clear = least > kValueRounding * bounds.values;
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
  bool outward = skin.sense > 0.0;
  bool falls = rise.x >= rise.z;
  Real from = min(rise.x, rise.z);
  Search search = Search(Real(0.0), from, falls && outward, false);
  if (search.bracketed) return search;
  if (sampleRay(from).value <= 0.0) {
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
    Sample at = sampleRay(root);
    low = at.value > 0.0 ? root : low;
    high = at.value > 0.0 ? high : root;
    Real next = root - at.value / at.slope;
    bool halves = (i > 7 && i % 4 == 3) || !(next >= low && next <= high);
    next = halves ? 0.5 * (low + high) : next;
    open = abs(next - root) > tolerance;
    steep = at.slope <= -5e-8 / tolerance;
    root = next;
  }
  return !open && steep;
}
