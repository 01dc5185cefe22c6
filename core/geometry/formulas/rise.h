// core/geometry/formulas/rise.h: limits of heights (docs/design.md, Rise limits).

/// A height s under the limit L: s up to L/2, then L - (L/2)^2 / s, which never reaches L. C1.
formula Real limitedRise(Real s, Real inverseLimit) {
  Real limit = num(1.0) / inverseLimit;
  return select(s * inverseLimit > num(0.5), limit - num(0.25) * limit * limit / s, s);
}

/// 1/L over muscles and carves that only touch the skin: L is twice the height, or depth, at which the root would lie
/// if F stayed as on the skin. Over muscles the limit fades from F = T/2 to none at T, where the skin is inside. So a
/// vertex just reached by an influence starts to move from 0, whatever lies further out or in.
/// @param onSkin  F on the skin, not 0.  @param inverseWidth  1/W of the skin's field.
formula Real inverseTouchLimit(Real onSkin, Real iso, Real isoRoot, Real isoRadius, Real inverseWidth) {
  Real t = min(max(num(0.0), onSkin - num(0.5) * iso) * (num(2.0) / iso), num(1.0));
  Real share = num(1.0) - t * t * (num(3.0) - num(2.0) * t);
  return share * slopeToRoot(onSkin, iso, isoRoot, isoRadius) * inverseWidth / (num(2.0) * abs(onSkin));
}
