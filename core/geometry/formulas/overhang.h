// core/geometry/formulas/overhang.h: heights where psi falls slowly, as below what hangs over the skin. Needs a type
// Rays and psiAt(Rays, Real), psi along them with its derivative (Sample).

/// When psi changes, its root t moves by the change over the derivative of psi: without limit where a minimum of psi
/// reaches 0, from where it leaps. So the height is the least of s + psi(s) / sigma for 0 <= s <= t: no change of psi
/// moves it by more than 1 / sigma times as much. It is t if psi falls by at least sigma all the way (docs/design.md,
/// Overhangs).
///
/// The least is sought at the ends of parts of [0, t] that do not depend on the root, and inside a part if the sum
/// falls at its start and rises at its end. Steps there alternate between the intersection of the tangents at both
/// ends, which finds a kink between straight sides, and the middle, since a curved side would stall the former. The
/// last step goes to the zero of the derivative by false position, the lowest point of a parabola. psi has a kink where
/// the field of one muscle gives way to that of another that is not linked to it.

/// sigma: half of the derivative on the skin of the skin's own field if its width were the muscles' mean radius.
formula Real overhangSlope(SkinRay skin, Real blendWidth, Real radius) {
  return num(2.0) * skinSlope(skin, num(0.0)) * blendWidth / radius;
}

/// An end of a part: s, and s + psi(s) / sigma with its derivative there.
struct PartEnd {
  Real at;
  Real sum;
  Real slope;
};

formula PartEnd partEndAt(Rays rays, Real s, Real inverseSigma) {
  Sample psi = psiAt(rays, s);
  PartEnd end = {s, s + psi.value * inverseSigma, num(1.0) + psi.slope * inverseSigma};
  return end;
}

/// Next s to try inside a part with low.slope < 0 and high.slope > 0.  @param kind  0: by tangents, 1: the middle, 2:
/// by false position.
formula Real lowestBetween(PartEnd low, PartEnd high, int kind) {
  Real extent = high.at - low.at;
  if (kind == 1) return low.at + num(0.5) * extent;
  Real turns = high.slope - low.slope;
  Real to = kind == 0 ? (high.slope * extent + (low.sum - high.sum)) / turns : num(0.0) - low.slope * extent / turns;
  return low.at + min(max(num(0.0), to), extent);
}

/// @param t  the root.  @param blendWidth  four times a part's length.  @param asked  otherwise t itself.
formula Real heightBelowOverhangs(Rays rays, Real t, Real sigma, Real blendWidth, Mask asked) {
  Real part = num(0.25) * blendWidth;
  const int kMostParts = 32;
  const int kNarrowings = 6;
  Real inverseSigma = num(1.0) / sigma;
  PartEnd from = partEndAt(rays, num(0.0), inverseSigma);
  Real height = select(asked, min(t, from.sum), t);
  for (int i = 0; i < kMostParts; ++i) {
    asked = both(asked, num(i) * part < t);
    if (!any(asked)) break;
    PartEnd to = partEndAt(rays, min(num(i + 1) * part, t), inverseSigma);
    height = select(both(asked, to.at < t), min(height, to.sum), height);
    PartEnd low = from;
    PartEnd high = to;
    Mask dips = both(asked, both(low.slope<num(0.0), high.slope> num(0.0)));
    for (int k = 0; k < kNarrowings && any(dips); ++k) {
      int kind = k % 2 == 0 ? 0 : (k + 1 < kNarrowings ? 1 : 2);
      PartEnd inside = partEndAt(rays, lowestBetween(low, high, kind), inverseSigma);
      height = select(dips, min(height, inside.sum), height);
      Mask falls = inside.slope < num(0.0);
      low.at = select(falls, inside.at, low.at);
      low.sum = select(falls, inside.sum, low.sum);
      low.slope = select(falls, inside.slope, low.slope);
      high.at = select(falls, high.at, inside.at);
      high.sum = select(falls, high.sum, inside.sum);
      high.slope = select(falls, high.slope, inside.slope);
      dips = both(dips, both(low.slope<num(0.0), high.slope> num(0.0)));
    }
    from = to;
  }
  return max(height, num(0.0));
}
