// shaders/compute/overhang.glsl: heights where psi falls slowly, as below what hangs over the skin, in numbers of the
// type Real. As core/smoothing/projection/overhang.h. Needs Real, Real2 and psiAt(Real), psi and its slope.
const float kOverhangSlope = 0.5, kPart = 0.25;
const int kMostParts = 32, kNarrowings = 3;

// Of psi, below which it falls slowly. @param radius  mean of the muscles'
Real overhangSlope(Real radius) {
  return Real(kOverhangSlope) * 4.0 * Real(isoRadius) * Real(isoRoot) * (1.0 - Real(isoRadius)) / radius;
}

// @param t  the root  @param sigma  overhangSlope()  @param blendWidth  h
Real belowOverhangs(Real t, Real sigma, Real blendWidth) {
  Real part = Real(kPart) * blendWidth;
  Real2 from = psiAt(Real(0.0));
  Real height = min(t, from.x / sigma);
  for (int i = 0; i < kMostParts && Real(i) * part < t; ++i) {
    Real low = Real(i) * part, high = min(Real(i + 1) * part, t);
    Real2 to = psiAt(high);
    if (high < t) height = min(height, high + to.x / sigma);
    Real falls = from.y + sigma, rises = to.y + sigma;  // The slope of sigma s + psi(s).
    for (int k = 0; k < kNarrowings && falls < Real(0.0) && rises > Real(0.0); ++k) {
      Real lowest = low - falls * (high - low) / (rises - falls);
      Real2 at = psiAt(lowest);
      height = min(height, lowest + at.x / sigma);
      Real slope = at.y + sigma;
      if (slope < Real(0.0)) {
        low = lowest;
        falls = slope;
      } else {
        high = lowest;
        rises = slope;
      }
    }
    from = to;
  }
  return max(height, Real(0.0));
}
