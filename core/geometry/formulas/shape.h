// core/geometry/formulas/shape.h: r^2 of capsules, eggs and bent spindles at points of their unit space.

/// Numbers of UnitShape.
struct ShapeNumbers {
  Real lateral;  ///< nu S(y) = lateral + taper y
  Real taper;
  Real bendX;  ///< The axis is at bend + curve y^2.
  Real bendZ;
  Real curveX;
  Real curveZ;
  Real core;
  Real inverseEnd;
};

/// Parts of the formula at one point, for r^2 and its gradient.
struct ShapePoint {
  Real y;
  Real x;  ///< From the axis, which may be bent.
  Real z;
  Real girth;  ///< nu S(y)
  Real end;    ///< Distance beyond the core over the end's length, signed like y.
};

formula ShapePoint shapePoint(ShapeNumbers shape, Real3 p) {
  ShapePoint at = {p.y, p.x - shape.bendX - shape.curveX * p.y * p.y, p.z - shape.bendZ - shape.curveZ * p.y * p.y,
                   shape.lateral + shape.taper * p.y,
                   (p.y - clamp(p.y, num(0.0) - shape.core, shape.core)) * shape.inverseEnd};
  return at;
}

formula Real shapeRSquared(ShapePoint at) {
  Real ends = at.end * at.end;
  return select(ends < num(1.0), at.girth * (at.x * at.x + at.z * at.z) + ends, ends);  // S may be negative beyond.
}

/// Half of d(r^2)/dp.
formula Real3 shapeHalfSlope(ShapeNumbers shape, ShapePoint at) {
  Real gx = at.girth * at.x;
  Real gz = at.girth * at.z;
  Real axis = num(0.5) * shape.taper * (at.x * at.x + at.z * at.z) -
              (at.y + at.y) * (shape.curveX * gx + shape.curveZ * gz) + at.end * shape.inverseEnd;
  Real3 slope = {gx, axis, gz};
  return slope;
}
