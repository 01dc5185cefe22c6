// shaders/compute/overhang.glsl: heights where psi falls slowly, as below what hangs over the skin, in numbers of the
// type Real. As core/surface/projection/swell.h. Needs Real, Real2 and psiAt(Real), psi and its slope.
const float kOverhangSlope = 0.5, kPart = 0.25;
const int kMostParts = 32, kNarrowings = 6;

// Of psi, below which it falls slowly. @param radius  mean of the muscles'
Real overhangSlope(Real radius) {
  return Real(kOverhangSlope) * 4.0 * Real(isoRadius) * Real(isoRoot) * (1.0 - Real(isoRadius)) / radius;
}

// An end of a part: where it is, and s + psi(s) / sigma there.
struct PartEnd {
  Real at;
  Real sum;
  Real slope;
};

PartEnd partEndAt(Real s, Real sigma) {
  Real2 here = psiAt(s);
  return PartEnd(s, s + here.x / sigma, Real(1.0) + here.y / sigma);
}

// Where to look inside a part in which low.slope < 0 and high.slope > 0. @param narrowing  from 0
Real lowestBetween(PartEnd low, PartEnd high, int narrowing) {
  Real way = high.at - low.at;
  if (narrowing % 2 != 0 && narrowing + 1 < kNarrowings) return low.at + Real(0.5) * way;
  Real turns = high.slope - low.slope;
  Real to = narrowing % 2 == 0 ? (high.slope * way + (low.sum - high.sum)) / turns : -low.slope * way / turns;
  return low.at + clamp(to, Real(0.0), way);
}

// @param t  the root  @param sigma  overhangSlope()  @param blendWidth  h
Real belowOverhangs(Real t, Real sigma, Real blendWidth) {
  Real part = Real(kPart) * blendWidth;
  PartEnd from = partEndAt(Real(0.0), sigma);
  Real height = min(t, from.sum);
  for (int i = 0; i < kMostParts && Real(i) * part < t; ++i) {
    PartEnd to = partEndAt(min(Real(i + 1) * part, t), sigma);
    if (to.at < t) height = min(height, to.sum);
    PartEnd low = from, high = to;
    for (int k = 0; k < kNarrowings && low.slope < Real(0.0) && high.slope > Real(0.0); ++k) {
      PartEnd inside = partEndAt(lowestBetween(low, high, k), sigma);
      height = min(height, inside.sum);
      if (inside.slope < Real(0.0)) {
        low = inside;
      } else {
        high = inside;
      }
    }
    from = to;
  }
  return max(height, Real(0.0));
}
