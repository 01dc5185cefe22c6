// core/geometry/formulas/patch.h: points and normals of curved patches, over an edge with corners 0 and 1 or a triangle
// with 0, 1 and 2, at barycentric weights u, v, s. `precise`: all engines round alike. Needs normalizeOr(v, fallback).

formula Real3 weighted(Real3 a, Real3 b, Real u, Real v) {
  Real3 none = {num(0.0), num(0.0), num(0.0)};
  precise Real3 sum = none + u * a + v * b;
  return sum;
}
formula Real3 weighted(Real3 a, Real3 b, Real3 c, Real u, Real v, Real s) {
  precise Real3 sum = weighted(a, b, u, v) + s * c;
  return sum;
}

/// The corner with the largest weight, the first if several are equal.
formula Real3 heaviest(Real3 a, Real3 b, Real u, Real v) { return select(u >= v, a, b); }
formula Real3 heaviest(Real3 a, Real3 b, Real3 c, Real u, Real v, Real s) {
  return select(both(u >= v, u >= s), a, select(v >= s, b, c));
}

formula Real3 direction(Real3 a, Real3 b, Real u, Real v) {
  return normalizeOr(weighted(a, b, u, v), heaviest(a, b, u, v));
}
formula Real3 direction(Real3 a, Real3 b, Real3 c, Real u, Real v, Real s) {
  return normalizeOr(weighted(a, b, c, u, v, s), heaviest(a, b, c, u, v, s));
}

/// Phong tessellation: a point pulled towards the mean of its projections onto the corners' tangent planes.
formula Real3 onPlane(Real3 point, Real3 corner, Real3 normal) {
  precise Real3 on = point - dot(point - corner, normal) * normal;
  return on;
}
formula Real3 phongPoint(Real3 flatPoint, Real3 onPlanes) {
  precise Real3 point = flatPoint * num(0.25) + onPlanes * num(0.75);
  return point;
}

/// Spherigon: mean of the points on the spheres through each corner, along the normal.  @param share  factor
formula Real sphereHeight(Real share, Real3 flatPoint, Real3 normal, Real3 corner, Real3 cornerNormal) {
  // 1 + N.Ni goes to 0 for opposite normals, which have no such sphere.
  precise Real between = num(1.0) + dot(normal, cornerNormal);
  precise Real height = share * dot(corner - flatPoint, normal + cornerNormal);
  return height / select(between < num(0.1), num(0.1), between);
}

/// Tangent control point a third of the way from a to b, moved into a's tangent plane.
formula Real3 tangentPoint(Real3 a, Real3 b, Real3 normal) {
  precise Real3 point = (num(2.0) * a + b - dot(b - a, normal) * normal) / num(3.0);
  return point;
}
/// Mid-edge normal: the mean reflected in the plane across the edge, so that inflections show.
formula Real3 edgeNormal(Real3 a, Real3 b, Real3 normalA, Real3 normalB) {
  precise Real3 along = b - a;
  precise Real3 sum = normalA + normalB;
  Real squared = dot(along, along);
  precise Real share = select(squared > num(0.0), num(2.0) * dot(along, sum) / squared, num(0.0));
  precise Real3 mirrored = sum - share * along;
  return normalizeOr(mirrored, normalA);
}

/// Inner control points of an edge.
struct PnEdge {
  Real3 b21;
  Real3 b12;
  Real3 n11;
};
formula PnEdge pnEdge(Real3 p0, Real3 p1, Real3 n0, Real3 n1) {
  PnEdge edge = {tangentPoint(p0, p1, n0), tangentPoint(p1, p0, n1), edgeNormal(p0, p1, n0, n1)};
  return edge;
}
formula Real3 pnPosition(PnEdge of, Real3 p0, Real3 p1, Real u, Real v) {
  precise Real3 position =
      p0 * (u * u * u) + of.b21 * (num(3.0) * u * u * v) + of.b12 * (num(3.0) * u * v * v) + p1 * (v * v * v);
  return position;
}
formula Real3 pnNormal(PnEdge of, Real3 n0, Real3 n1, Real u, Real v) {
  precise Real3 normal = n0 * (u * u) + of.n11 * (u * v) + n1 * (v * v);
  return normalizeOr(normal, heaviest(n0, n1, u, v));
}

/// The same of a triangle.
struct PnTriangle {
  Real3 b210;
  Real3 b120;
  Real3 b021;
  Real3 b012;
  Real3 b102;
  Real3 b201;
  Real3 b111;
  Real3 n110;
  Real3 n011;
  Real3 n101;
};
formula PnTriangle pnTriangle(Real3 p0, Real3 p1, Real3 p2, Real3 n0, Real3 n1, Real3 n2) {
  Real3 b210 = tangentPoint(p0, p1, n0);
  Real3 b120 = tangentPoint(p1, p0, n1);
  Real3 b021 = tangentPoint(p1, p2, n1);
  Real3 b012 = tangentPoint(p2, p1, n2);
  Real3 b102 = tangentPoint(p2, p0, n2);
  Real3 b201 = tangentPoint(p0, p2, n0);
  precise Real3 edgeMean = (b210 + b120 + b021 + b012 + b102 + b201) / num(6.0);
  precise Real3 cornerMean = (p0 + p1 + p2) / num(3.0);
  precise Real3 b111 = edgeMean + (edgeMean - cornerMean) * num(0.5);
  PnTriangle triangle = {b210,
                         b120,
                         b021,
                         b012,
                         b102,
                         b201,
                         b111,
                         edgeNormal(p0, p1, n0, n1),
                         edgeNormal(p1, p2, n1, n2),
                         edgeNormal(p2, p0, n2, n0)};
  return triangle;
}
formula Real3 pnPosition(PnTriangle of, Real3 p0, Real3 p1, Real3 p2, Real u, Real v, Real s) {
  precise Real3 position = p0 * (u * u * u) + p1 * (v * v * v) + p2 * (s * s * s) +
                           (of.b210 * (u * u * v) + of.b120 * (u * v * v) + of.b021 * (v * v * s) +
                            of.b012 * (v * s * s) + of.b102 * (u * s * s) + of.b201 * (u * u * s)) *
                               num(3.0) +
                           of.b111 * (num(6.0) * u * v * s);
  return position;
}
formula Real3 pnNormal(PnTriangle of, Real3 n0, Real3 n1, Real3 n2, Real u, Real v, Real s) {
  precise Real3 normal =
      n0 * (u * u) + n1 * (v * v) + n2 * (s * s) + of.n110 * (u * v) + of.n011 * (v * s) + of.n101 * (u * s);
  return normalizeOr(normal, heaviest(n0, n1, n2, u, v, s));
}
