// core/geometry/formulas/potential.h: the potential g, parts of groups in F, the skin's own field along a ray.

/// A number along a ray, and its derivative.
struct Sample {
  Real value;
  Real slope;
};

/// factor g, where g = w^2 is a function of w = max(0, 1 - r^2) (paper 3.1).
formula Real potential(Real factor, Real w) { return factor * w * w; }

/// Half of dg/dw. The gradient of g is -2 potentialRate(w) times that of r^2. Grows with w, like g.
formula Real potentialRate(Real w) { return w; }

/// w at which g has a value, 0..1.
formula Real potentialInverse(Real value) { return sqrt(value); }

/// g(root) - g(root - sense fall), times sense; exact to the last place for a tiny fall.
formula Real potentialFall(Real root, Real sense, Real fall) { return fall * (root + root - sense * fall); }

/// |F| / |r - r_T| for the r at which g = T - F, without cancelling.  @param root  w of T.  @param radius  r_T
formula Real slopeToRoot(Real onSkin, Real iso, Real root, Real radius) {
  Real left = potentialInverse(min(max(num(0.0), iso - onSkin), num(1.0)));
  return (root + left) * (sqrt(num(1.0) - left) + radius);
}

/// kappa of a muscle (docs/design.md, Grooves): two alike have a groove of `width`, however far they reach.
/// @param radius  mean, of the visible ellipsoid; world units, like `width`.
formula Real grooveOf(Real width, Real radius, Real reach) {
  return min(num(2.0), (width + width) / (radius * (reach * reach - num(1.0))));
}

/// Part in F of a group with sum x, whose cliques have the share m; y is the sum of its muscles' parts, each times its
/// kappa. Also part in a derivative of F, of the derivatives of x and y: F is largest at these shares.
formula Real softPart(Real x, Real y, Real m) { return m * (x + num(0.5) * (num(1.0) - m) * y); }
/// Its derivative by m.
formula Real softRate(Real x, Real y, Real m) { return x + (num(0.5) - m) * y; }

/// A clique's share of F among disjoint ones: it falls with the rate at which F rises by it.
struct Level {
  Real top;      ///< x + y / 2: the rate without a share.
  Real inverse;  ///< 1 / y; 0: it has no share at any rate.
};
formula Real shareAt(Level level, Real rate) { return max(num(0.0), (level.top - rate) * level.inverse); }

/// Two cliques: by how much F rises for a share that the second gives to the first, and how fast that falls.
struct Exchange {
  Real gain;
  Real fall;
};

/// The skin's own field along a ray that starts on the skin: g at r = r_T + sense t / W.
struct SkinRay {
  Real sense;         ///< 1: outwards, -1: inwards.
  Real inverseWidth;  ///< 1 / W
  Real isoRadius;     ///< r_T
  Real isoRoot;       ///< w of T.
  Real maxFall;       ///< Upper bound of the fall of w: outwards, the field ends.
};

formula Real skinFall(SkinRay skin, Real t) {
  Real u = t * skin.inverseWidth;
  return min(u * (skin.isoRadius + skin.isoRadius + skin.sense * u), skin.maxFall);
}
formula Real skinRadius(SkinRay skin, Real t) {
  return max(num(0.0), skin.isoRadius + skin.sense * (t * skin.inverseWidth));
}
/// Half of dg/dw there.
formula Real skinRate(SkinRay skin, Real t) { return potentialRate(skin.isoRoot - skin.sense * skinFall(skin, t)); }
/// sense (g - T): falls from 0.
formula Real skinValue(SkinRay skin, Real t) {
  return num(0.0) - potentialFall(skin.isoRoot, skin.sense, skinFall(skin, t));
}
/// Its derivative by t, divided by -4.
formula Real skinSlope(SkinRay skin, Real t) { return skin.inverseWidth * (skinRadius(skin, t) * skinRate(skin, t)); }
