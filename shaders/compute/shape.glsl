// shaders/compute/shape.glsl: the numbers of a muscle that is no ellipsoid, for core/geometry/formulas/shape.h.
ShapeNumbers numbersOf(Primitive p) {
  return ShapeNumbers(p.section.x, p.section.y, p.bendCurve.x, p.bendCurve.y, p.bendCurve.z, p.bendCurve.w, p.section.z,
                      p.section.w);
}
bool isBent(Primitive p) { return p.bendCurve.z != 0.0 || p.bendCurve.w != 0.0; }
bool tapers(Primitive p) { return p.section.y != 0.0; }
