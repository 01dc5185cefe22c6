// shaders/compute/patch.glsl: a point of a curved patch over an edge or a control triangle. Formulas and their order
// as core/surface/patches/patch_lanes.h.
vec3 P[3];  // Corners.
vec3 N[3];
vec3 R[3];  // Rise directions there.

const int kPn = 0, kPhong = 1, kSpherigon = 2, kFlat = 3;

vec3 weighted(vec3 a[3], vec3 w, int corners) {
  precise vec3 sum = w.x * a[0] + w.y * a[1];
  if (corners == 3) {
    precise vec3 all = sum + w.z * a[2];
    return all;
  }
  return sum;
}

vec3 heaviest(vec3 a[3], vec3 w, int corners) {
  if (w.x >= w.y && w.x >= w.z) return a[0];
  return corners == 2 || w.y >= w.z ? a[1] : a[2];
}

vec3 direction(vec3 a[3], vec3 w, int corners) { return normalizeOr(weighted(a, w, corners), heaviest(a, w, corners)); }

// A third of the way from a to b, moved into a's tangent plane.
vec3 tangentPoint(int a, int b) {
  precise vec3 point = (2.0 * P[a] + P[b] - dotOf(P[b] - P[a], N[a]) * N[a]) / 3.0;
  return point;
}

// The mean normal reflected in the plane across the edge.
vec3 edgeNormal(int a, int b) {
  precise vec3 along = P[b] - P[a];
  precise vec3 sum = N[a] + N[b];
  float squared = dotOf(along, along);
  precise float v = squared > 0.0 ? 2.0 * dotOf(along, sum) / squared : 0.0;
  precise vec3 mirrored = sum - v * along;
  return normalizeOr(mirrored, N[a]);
}

void pnEdge(vec3 w, out vec3 position, out vec3 normal) {
  float u = w.x, v = w.y;
  vec3 b21 = tangentPoint(0, 1), b12 = tangentPoint(1, 0), n11 = edgeNormal(0, 1);
  precise vec3 p = P[0] * (u * u * u) + b21 * (3.0 * u * u * v) + b12 * (3.0 * u * v * v) + P[1] * (v * v * v);
  precise vec3 n = N[0] * (u * u) + n11 * (u * v) + N[1] * (v * v);
  position = p;
  normal = normalizeOr(n, heaviest(N, w, 2));
}

void pnTriangle(vec3 w, out vec3 position, out vec3 normal) {
  float u = w.x, v = w.y, s = w.z;
  vec3 b210 = tangentPoint(0, 1), b120 = tangentPoint(1, 0), b021 = tangentPoint(1, 2), b012 = tangentPoint(2, 1),
       b102 = tangentPoint(2, 0), b201 = tangentPoint(0, 2);
  precise vec3 edgeMean = (b210 + b120 + b021 + b012 + b102 + b201) / 6.0;
  precise vec3 cornerMean = (P[0] + P[1] + P[2]) / 3.0;
  precise vec3 b111 = edgeMean + (edgeMean - cornerMean) * 0.5;
  precise vec3 p = P[0] * (u * u * u) + P[1] * (v * v * v) + P[2] * (s * s * s) +
                   (b210 * (u * u * v) + b120 * (u * v * v) + b021 * (v * v * s) + b012 * (v * s * s) +
                    b102 * (u * s * s) + b201 * (u * u * s)) * 3.0 +
                   b111 * (6.0 * u * v * s);
  precise vec3 n = N[0] * (u * u) + N[1] * (v * v) + N[2] * (s * s) + edgeNormal(0, 1) * (u * v) +
                   edgeNormal(1, 2) * (v * s) + edgeNormal(2, 0) * (u * s);
  position = p;
  normal = normalizeOr(n, heaviest(N, w, 3));
}

vec3 phongPoint(vec3 w, int corners) {
  vec3 flatPoint = weighted(P, w, corners);
  vec3 onPlanes[3];
  for (int i = 0; i < 3; ++i) {
    precise vec3 onPlane = flatPoint - dotOf(flatPoint - P[i], N[i]) * N[i];
    onPlanes[i] = onPlane;
  }
  precise vec3 point = flatPoint * 0.25 + weighted(onPlanes, w, corners) * 0.75;
  return point;
}

vec3 spherigonPoint(vec3 w, vec3 normal, int corners) {
  vec3 flatPoint = weighted(P, w, corners);
  precise float height = 0.0;
  precise float sum = 0.0;
  for (int i = 0; i < corners; ++i) {
    precise float between = 1.0 + dotOf(normal, N[i]);
    float along = between < 0.1 ? 0.1 : between;
    float squared = w[i] * w[i];
    height = height + squared * dotOf(P[i] - flatPoint, normal + N[i]) / along;
    sum = sum + squared;
  }
  precise vec3 point = flatPoint + normal * (height / sum);
  return point;
}

void patchPoint(vec3 w, int corners, out vec3 position, out vec3 normal) {
  if (patchKind == kPn) {
    if (corners == 2) pnEdge(w, position, normal);
    else pnTriangle(w, position, normal);
    return;
  }
  normal = direction(N, w, corners);
  if (patchKind == kPhong) position = phongPoint(w, corners);
  else if (patchKind == kSpherigon) position = spherigonPoint(w, normal, corners);
  else position = weighted(P, w, corners);
}
