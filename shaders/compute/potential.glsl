// shaders/compute/potential.glsl: r^2 of muscles at a point. As core/rig/field.cpp.
// Includes nothing: field.glsl and, with Real float, shape.glsl and its formulas come before.
vec3 inUnit(Primitive p, vec3 d) {
  if (p.toUnit[2].w > 0.0) return d;
  precise vec3 y = d.x * p.toUnit[0].xyz + d.y * p.toUnit[1].xyz + d.z * p.toUnit[2].xyz;
  return y;
}

float rSquaredAt(Primitive p, vec3 fromCenter) {
  vec3 y = inUnit(p, fromCenter);
  return isShaped(p) ? shapeRSquared(shapePoint(numbersOf(p), y)) : scaleOf(p) * dotOf(y, y);
}

// Half of d(r^2)/dx.
vec3 halfSlopeAt(Primitive p, vec3 fromCenter) {
  if (p.toUnit[2].w > 0.0) return scaleOf(p) * fromCenter;
  vec3 y = inUnit(p, fromCenter);
  if (isShaped(p)) y = shapeHalfSlope(numbersOf(p), shapePoint(numbersOf(p), y));
  return vec3(dotOf(p.toUnit[0].xyz, y), dotOf(p.toUnit[1].xyz, y), dotOf(p.toUnit[2].xyz, y));
}
