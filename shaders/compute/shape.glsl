// shaders/compute/shape.glsl: r^2 of capsules, eggs and bent spindles at a point, in numbers of the type Real. As
// core/surface/roots/shape_lanes.h.
struct ShapePoint {
  Real y;
  Real x, z;   // From the axis, which may be bent.
  Real girth;  // nu S(y)
  Real end;    // Beyond the core, over the end's length, signed like y.
};

ShapePoint shapeAt(Primitive p, Real3 q) {
  Real core = p.section.z;
  return ShapePoint(q.y, q.x - p.bendCurve.x - p.bendCurve.z * q.y * q.y,
                    q.z - p.bendCurve.y - p.bendCurve.w * q.y * q.y,
                    p.section.x + p.section.y * q.y, (q.y - clamp(q.y, -core, core)) * p.section.w);
}

Real rSquaredOf(ShapePoint s) {
  Real ends = s.end * s.end;
  return ends < 1.0 ? s.girth * (s.x * s.x + s.z * s.z) + ends : ends;
}

// Half of d(r^2)/dp.
Real3 halfSlopeOf(Primitive p, ShapePoint s) {
  Real gx = s.girth * s.x, gz = s.girth * s.z;
  Real axis = 0.5 * p.section.y * (s.x * s.x + s.z * s.z) - 2.0 * s.y * (p.bendCurve.z * gx + p.bendCurve.w * gz) +
              s.end * p.section.w;
  return Real3(gx, axis, gz);
}
