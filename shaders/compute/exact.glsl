// shaders/compute/exact.glsl: the first change of sign of the field along a ray, in double precision: roots isolated
// between breakpoints, then Newton's steps in the bracket. As core/surface/roots/ray_field.cpp and isolation.h.
const int kMostExactTerms = 96;  // No place of the skin sees more muscles, or the surface is the processor's.

struct ExactTerm {  // r^2 = a t^2 + 2 b t + c, f = factor (1 - r^2)^2 for enter < t < leave.
  double a, b, c, factor, enter, leave;
  uint slot;
};
ExactTerm exact[kMostExactTerms + 1];
int exactCount;

double rSquaredOf(ExactTerm term, double t) { return (term.a * t + 2.0lf * term.b) * t + term.c; }
bool isActive(ExactTerm term, double t) { return t > term.enter && t < term.leave; }

void addPrimitive(Primitive p, float weight, uint slot, vec3 from, vec3 direction) {
  dvec3 y = dvec3(from - p.center.xyz), yd = dvec3(direction);
  double scale = 1.0lf;
  if (p.toUnit[2].w > 0.0) {
    scale = double(p.toUnit[2].w) * double(p.toUnit[2].w);
  } else {
    dmat3 toUnit = dmat3(dvec3(p.toUnit[0].xyz), dvec3(p.toUnit[1].xyz), dvec3(p.toUnit[2].xyz));
    y = toUnit * y;
    yd = toUnit * yd;
  }
  ExactTerm term;
  term.a = scale * dot(yd, yd);
  term.b = scale * dot(y, yd);
  term.c = scale * dot(y, y);
  double discriminant = term.b * term.b - term.a * (term.c - 1.0lf);
  if (!(term.a > 0.0lf) || !(discriminant > 0.0lf)) return;
  double root = sqrt(discriminant);
  term.enter = (-term.b - root) / term.a;
  term.leave = (-term.b + root) / term.a;
  if (term.leave <= 0.0lf) return;
  term.factor = double(strengthOf(p)) * double(weight);
  term.slot = strengthOf(p) < 0.0 ? kEverySum : slot;
  exact[exactCount++] = term;
}

// All that the vertex sees.
void gatherTerms(vec3 from, vec3 direction) {
  for (int i = firstCandidate; i < endCandidate; ++i) {
    Candidate c = candidates[i];
    Primitive p = primitives[firstPrimitive + c.primitive];
    float weight = weightOf(c);
    vec3 fromCenter = from - p.center.xyz;
    float squared = dot(fromCenter, fromCenter), along = dot(fromCenter, direction);
    bool mayMeet = squared - along * along < 1.01 * p.center.w * p.center.w + 1e-5 * squared;
    if (weight > 0.0 && p.center.w > 0.0 && mayMeet) addPrimitive(p, weight, c.slot, from, direction);
  }
}

// phi at t, and its slope.
dvec2 sampleExact(double t) {
  dvec2 everywhere = dvec2(double(-iso), 0.0lf), best = dvec2(0.0lf);
  for (int k = 0; k < cliquesSeen; ++k) {
    dvec2 sum = dvec2(0.0lf);
    for (int i = 0; i < exactCount; ++i) {
      bool always = exact[i].slot == kEverySum;
      if (always ? k > 0 : !holds(cliqueAt(k), exact[i].slot)) continue;
      double w = 1.0lf - rSquaredOf(exact[i], t);
      if (w <= 0.0lf || t < exact[i].enter || t > exact[i].leave) continue;
      dvec2 part = exact[i].factor * w * dvec2(w, -4.0lf * (exact[i].a * t + exact[i].b));
      if (always) everywhere += part;
      else sum += part;
    }
    if (sum.x > best.x) best = sum;
  }
  return everywhere + best;
}

// Quartics in Bernstein form on [0, 1]. Without arrays: some drivers lose doubles in those.
struct Quartic {
  double b0, b1, b2, b3, b4;
};

// Sign times the sum of one clique on a stretch.
Quartic cliqueOn(int k, double begin, double end, double sign) {
  double base = double(-iso);
  Quartic q = Quartic(base, base, base, base, base);
  double middle = 0.5lf * (begin + end);
  for (int i = 0; i < exactCount; ++i) {
    if (exact[i].slot != kEverySum && !holds(cliqueAt(k), exact[i].slot)) continue;
    if (!isActive(exact[i], middle)) continue;
    double f = exact[i].factor;
    double w0 = 1.0lf - rSquaredOf(exact[i], begin);
    double w1 = 1.0lf - (exact[i].a * begin * end + exact[i].b * (begin + end) + exact[i].c);
    double w2 = 1.0lf - rSquaredOf(exact[i], end);
    q.b0 += f * w0 * w0;
    q.b1 += f * w0 * w1;
    q.b2 += f * (w0 * w2 + 2.0lf * w1 * w1) / 3.0lf;
    q.b3 += f * w1 * w2;
    q.b4 += f * w2 * w2;
  }
  return Quartic(sign * q.b0, sign * q.b1, sign * q.b2, sign * q.b3, sign * q.b4);
}

double valueAt(Quartic q, double u) {
  double v = 1.0lf - u;
  return v * v * (v * v * q.b0 + 4.0lf * v * u * q.b1 + 6.0lf * u * u * q.b2) +
         u * u * u * (4.0lf * v * q.b3 + u * q.b4);
}

// De Casteljau: the part left or right of u, again on [0, 1].
double between(double a, double b, double u) { return a + (b - a) * u; }
Quartic leftOf(Quartic q, double u) {
  double c0 = between(q.b0, q.b1, u), c1 = between(q.b1, q.b2, u), c2 = between(q.b2, q.b3, u);
  double c3 = between(q.b3, q.b4, u);
  double d0 = between(c0, c1, u), d1 = between(c1, c2, u), d2 = between(c2, c3, u);
  double e0 = between(d0, d1, u), e1 = between(d1, d2, u);
  return Quartic(q.b0, c0, d0, e0, between(e0, e1, u));
}
Quartic rightOf(Quartic q, double u) {
  double c0 = between(q.b0, q.b1, u), c1 = between(q.b1, q.b2, u), c2 = between(q.b2, q.b3, u);
  double c3 = between(q.b3, q.b4, u);
  double d0 = between(c0, c1, u), d1 = between(c1, c2, u), d2 = between(c2, c3, u);
  double e0 = between(d0, d1, u), e1 = between(d1, d2, u);
  return Quartic(between(e0, e1, u), e1, d2, c3, q.b4);
}

// Adds a coefficient to a count of changes of sign. @param last  the one before that is not 0
void countChange(double b, inout double last, inout int changes) {
  if (b == 0.0lf) return;
  if (last * b < 0.0lf) ++changes;
  last = b;
}
int signChanges(Quartic q) {
  int changes = 0;
  double last = q.b0;
  countChange(q.b1, last, changes);
  countChange(q.b2, last, changes);
  countChange(q.b3, last, changes);
  countChange(q.b4, last, changes);
  return changes;
}

// The one root of q on [0, 1], q(0) > 0 > q(1).
double bracketedNewton(Quartic q, double within) {
  double c1 = 4.0lf * (q.b1 - q.b0);
  double c2 = 6.0lf * (q.b2 - 2.0lf * q.b1 + q.b0);
  double c3 = 4.0lf * (q.b3 - 3.0lf * q.b2 + 3.0lf * q.b1 - q.b0);
  double c4 = q.b4 - 4.0lf * q.b3 + 6.0lf * q.b2 - 4.0lf * q.b1 + q.b0;
  double low = 0.0lf, high = 1.0lf, u = q.b0 / (q.b0 - q.b4);
  for (int i = 0; i < 60; ++i) {
    double value = (((c4 * u + c3) * u + c2) * u + c1) * u + q.b0;
    double slope = ((4.0lf * c4 * u + 3.0lf * c3) * u + 2.0lf * c2) * u + c1;
    if (value > 0.0lf) low = u;
    else high = u;
    double next = slope != 0.0lf ? u - value / slope : -1.0lf;
    if (!(next >= low && next <= high)) next = 0.5lf * (low + high);
    if (abs(next - u) <= within || high - low <= within) return next;
    u = next;
  }
  return u;
}

const double kNone = -1.0lf;

const int kMostHalvings = 30;

// First fall of q through 0 on [0, 1]; kNone if there is none. The index-th of 2^level parts is halved until its signs
// tell (Descartes' rule); the next one is the widest that begins where it ends.
double isolate(Quartic q, double within) {
  uint index = 0u;
  int level = 0;
  while (index < 1u << level) {
    double size = 1.0lf / double(1u << level);
    double low = double(index) * size, high = low + size;
    Quartic part = level == 0 ? q : rightOf(leftOf(q, high), low / high);
    if (part.b0 <= 0.0lf) return low;
    int changes = signChanges(part);
    bool endsBelow = part.b4 < 0.0lf;
    if (changes == 1 && endsBelow) return low + size * bracketedNewton(part, within / size);
    if (changes != 0 && level < kMostHalvings) {
      index *= 2u;
      ++level;
    } else {
      if (changes != 0 && endsBelow) return low;
      ++index;
      int wider = min(findLSB(index), level);
      index >>= wider;
      level -= wider;
    }
  }
  return kNone;
}

double firstFall(Quartic q, double from, double within) {
  if (from >= 1.0lf) return q.b4 <= 0.0lf ? 1.0lf : kNone;
  double rest = isolate(from > 0.0lf ? rightOf(q, from) : q, within / (1.0lf - from));
  return rest == kNone ? kNone : from + (1.0lf - from) * rest;
}

// Where the largest of the cliques' sums falls to 0: follows one until it falls, then whichever still stands.
double firstFallOfMaximum(double begin, double end, double within) {
  double u = 0.0lf;
  for (int change = 0; change <= 4 * cliquesSeen; ++change) {
    int highest = 0;
    double most = valueAt(cliqueOn(0, begin, end, 1.0lf), u);
    for (int k = 1; k < cliquesSeen; ++k) {
      double value = valueAt(cliqueOn(k, begin, end, 1.0lf), u);
      if (value > most) highest = k;
      most = max(most, value);
    }
    if (most <= 1e-15lf) return u;
    double fall = firstFall(cliqueOn(highest, begin, end, 1.0lf), u, within);
    if (fall == kNone) return kNone;
    u = max(fall, u);
    bool anotherStands = false;
    for (int k = 0; k < cliquesSeen; ++k) {
      anotherStands = anotherStands || (k != highest && valueAt(cliqueOn(k, begin, end, 1.0lf), u) > 1e-12lf);
    }
    if (!anotherStands) return u;
  }
  return u;
}

// phi < 0 at the start: the first of the sums that reaches 0.
double firstFallOfAny(double begin, double end, double within) {
  double first = kNone;
  for (int k = 0; k < cliquesSeen; ++k) {
    double fall = firstFall(cliqueOn(k, begin, end, -1.0lf), 0.0lf, within);
    if (fall != kNone && (first == kNone || fall < first)) first = fall;
  }
  return first;
}

// First t in [begin, end] where phi changes its sign; kNone: it keeps it.
double firstChange(double begin, double end, bool fromPositive) {
  for (double from = begin; from < end;) {
    double to = end;
    for (int i = 0; i < exactCount; ++i) {
      if (exact[i].enter > from) to = min(to, exact[i].enter);
      if (exact[i].leave > from) to = min(to, exact[i].leave);
    }
    double within = double(tolerance) / (to - from);
    double u = fromPositive ? firstFallOfMaximum(from, to, within) : firstFallOfAny(from, to, within);
    if (u != kNone) return from + u * (to - from);
    from = to;
  }
  return kNone;
}
