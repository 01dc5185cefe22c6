// shaders/compute/ray.glsl: the field along a ray in single precision, and a bracket around its first change of sign that
// rounding cannot have moved. As core/smoothing/roots/ray_lanes.h, one ray an invocation; docs/performance.md proves it.
const int kMostTerms = 24;  // More along one ray: it has no certificate.
const float kFar = 1e30;

struct Term {  // w(t) = peak - a (t - middle)^2, f(t) = factor max(0, w)^2.
  float a, middle, peak, factor;
  uint bit;
};
Term terms[kMostTerms];
int termCount;

// psi = sense (skin + F - T).
bool skinFalls;
float sense, inverseWidth, maxFall;

float skinFall(float t) {
  float u = t * inverseWidth;
  return min(u * (isoRadius + isoRadius + sense * u), maxFall);
}
float skinRadius(float t) { return max(0.0, isoRadius + sense * (t * inverseWidth)); }
float skinRoot(float t) { return isoRoot - sense * skinFall(t); }
float skinValue(float t) {
  if (!skinFalls) return -sense * iso;
  float e = skinFall(t);
  return -e * (isoRoot + isoRoot - sense * e);
}

// Whether a ray may meet a ball ahead; rounding never says no where it does.
bool mayMeet(vec3 fromCenter, vec3 d, float radius, bool ahead) {
  float squared = dot(fromCenter, fromCenter);
  float along = dot(fromCenter, d);
  float within = 1.01 * radius * radius + 1e-5 * squared;
  return squared - along * along < within && (!ahead || along < 0.0 || squared < within);
}

// False: there are too many.
bool fillTerms(vec3 from, vec3 d) {
  termCount = 0;
  for (int i = firstCandidate; i < endCandidate; ++i) {
    Candidate c = candidates[i];
    Primitive p = primitives[firstPrimitive + c.primitive];
    vec3 fromCenter = from - p.center.xyz;
    if (p.center.w == 0.0 || !mayMeet(fromCenter, d, p.center.w, true)) continue;
    float factor = strengthOf(p) * weightOf(c);
    if (factor == 0.0) continue;
    vec3 y = inUnit(p, fromCenter);
    vec3 yd = inUnit(p, d);
    float squared = dotOf(yd, yd);
    float middle = -dotOf(y, yd) / squared;
    vec3 nearest = y + middle * yd;
    float peak = 1.0 - scaleOf(p) * dotOf(nearest, nearest);
    float a = scaleOf(p) * squared;
    if (!(peak > 0.0) || !(middle > 0.0 || peak - a * middle * middle > 0.0)) continue;
    if (termCount == kMostTerms) return false;
    terms[termCount++] = Term(a, middle, peak, sense * factor, factor < 0.0 ? kEverySum : c.bit);
  }
  return true;
}

// psi and its slope.
vec2 sampleRay(float t) {
  vec2 everywhere = vec2(0.0), best = vec2(0.0);
  for (int k = 0; k < cliqueCount; ++k) {
    uint clique = cliqueAt(k);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < termCount; ++i) {
      bool carves = terms[i].bit == kEverySum;
      if (carves ? k > 0 : (terms[i].bit & clique) == 0u) continue;
      float d = t - terms[i].middle;
      float ad = terms[i].a * d;
      float w = max(0.0, terms[i].peak - ad * d);
      vec2 part = terms[i].factor * w * vec2(w, ad);
      if (carves) everywhere += part;
      else sum += part;
    }
    if (sense * sum.x > sense * best.x) best = sum;
  }
  vec2 field = everywhere + best;
  float slope = skinFalls ? -4.0 * inverseWidth * (skinRadius(t) * skinRoot(t)) : 0.0;
  return vec2(skinValue(t) + field.x, slope - 4.0 * field.y);
}

struct Bounds {
  float value;     // psi is nowhere less ...
  float maxSlope;  // ... and its slope nowhere more ...
  float minSlope;  // ... and nowhere less.
  float values;    // Sums of the magnitudes that went into them: what rounding is measured by.
  float slopes;
  float atEnd;
};

Bounds boundsOf(float t0, float t1) {
  Bounds all = Bounds(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);  // Of carves; magnitudes of everything.
  float value = -kFar, atEnd = -kFar, maxSlope = -kFar, minSlope = kFar;
  for (int k = 0; k < cliqueCount; ++k) {
    uint clique = cliqueAt(k);
    float sumLow = 0.0, sumEnd = 0.0, sumMax = 0.0, sumMin = 0.0;
    for (int i = 0; i < termCount; ++i) {
      bool carves = terms[i].bit == kEverySum;
      if (k > 0 && (carves || (terms[i].bit & clique) == 0u)) continue;
      float a = terms[i].a, factor = terms[i].factor;
      float d0 = t0 - terms[i].middle, d1 = t1 - terms[i].middle;
      float w0 = max(0.0, terms[i].peak - a * d0 * d0), w1 = max(0.0, terms[i].peak - a * d1 * d1);
      float low = min(w0, w1), high = d0 < 0.0 && d1 > 0.0 ? max(0.0, terms[i].peak) : max(w0, w1);
      float atLow = factor * low * low, atHigh = factor * high * high;
      float rate = factor * a;
      float minDw = rate * (min(d0, 0.0) * high + max(d0, 0.0) * low);
      float maxDw = rate * (max(d1, 0.0) * high + min(d1, 0.0) * low);
      bool adds = factor >= 0.0;
      float least = adds ? atLow : atHigh;
      float most = -(adds ? minDw : maxDw), fewest = -(adds ? maxDw : minDw);
      float end = factor * w1 * w1;
      if (k == 0) {
        all.values += abs(atHigh);
        all.slopes += max(abs(most), abs(fewest));
      }
      if (carves) {
        all.value += least;
        all.atEnd += end;
        all.maxSlope += most;
        all.minSlope += fewest;
      } else if ((terms[i].bit & clique) != 0u) {
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
  float skin = skinValue(t1);
  Bounds psi = Bounds(skin + all.value + sense * value, all.maxSlope + maxSlope, all.minSlope + minSlope,
                      all.values + abs(skin), all.slopes, skin + all.atEnd + sense * atEnd);
  if (skinFalls) {
    vec2 radius = vec2(skinRadius(t0), skinRadius(t1)), root = vec2(skinRoot(t0), skinRoot(t1));
    float fall = inverseWidth * max(radius.x, radius.y) * max(root.x, root.y);
    psi.maxSlope -= inverseWidth * min(radius.x, radius.y) * min(root.x, root.y);
    psi.minSlope -= fall;
    psi.slopes += fall;
  }
  psi.maxSlope *= 4.0;
  psi.minSlope *= 4.0;
  psi.slopes *= 4.0;
  return psi;
}

// How far a search has come: psi > 0 up to low, and a root lies before high in a stretch where psi only falls.
struct Search {
  float low, high;
  bool bracketed, rootless;
};

// From low to `end`, stretch after stretch, the first up to high. psi only falls from `to` on.
void march(float to, float end, bool endsBelow, int stretches, inout Search search) {
  float low = search.low, high = search.high;
  for (int i = 0; i < stretches; ++i) {
    Bounds bounds = boundsOf(low, high);
    float enough = 1e-3 * bounds.slopes;
    bool falls = bounds.maxSlope <= -enough;
    if (falls && bounds.atEnd <= 0.0) {
      search = Search(low, high, true, false);
      return;
    }
    float stretch = high - low;
    if (!(bounds.value > 1e-5 * bounds.values) && !(bounds.minSlope >= enough) && !(falls && bounds.atEnd > 0.0)) {
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
}

// From the skin, psi = 0 and falling. psi might rise from rise.x to rise.y; the search ends at rise.z.
Search bracketFromSkin(vec3 rise) {
  bool outward = sense > 0.0;
  bool falls = rise.x >= rise.z;
  float from = min(rise.x, rise.z);
  Search search = Search(0.0, from, falls && outward, false);
  if (search.bracketed) return search;
  if (sampleRay(from).x <= 0.0) {
    search.bracketed = true;
    return search;
  }
  search.rootless = falls;
  if (falls) return search;
  float to = min(rise.y, rise.z);
  search.low = from;
  search.high = to;
  march(to, rise.z, outward, 20, search);
  return search;
}

// Between two ways of a ray without a skin of its own.
Search bracketBetween(float begin, float end) {
  Search search = Search(begin, end, false, !(begin < end));
  if (search.rootless) return search;
  if (sampleRay(begin).x <= 0.0) {
    search.high = begin;
    search.bracketed = true;
    return search;
  }
  march(end, end, false, 40, search);
  return search;
}

// Newton's steps kept inside the bracket. False: rounding may have moved the root.
bool newton(Search search, out float root) {
  float low = search.low, high = search.high;
  root = search.low;
  for (int i = 0; i < 24; ++i) {
    vec2 at = sampleRay(root);
    if (at.x > 0.0) low = root;
    else high = root;
    float next = root - at.x / at.y;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    bool still = abs(next - root) <= tolerance;
    root = next;
    if (still) return at.y <= -5e-8 / tolerance;
  }
  return false;
}
