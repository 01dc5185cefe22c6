// core/surface/patches/patch_lanes.h: the patches, an edge or triangle per lane. Included once per instruction set.
#if defined(SINEW_PATCH_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_PATCH_LANES_H
#undef SINEW_PATCH_LANES_H
#else
#define SINEW_PATCH_LANES_H
#endif

#include <array>
#include <cstddef>

#include "core/geometry/lanes.h"
#include "hwy/highway.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/refinement.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Barycentric; s is 0 on an edge.
struct Weights {
  V u;
  V v;
  V s;
};

template <std::size_t kCorners>
struct Corners {
  V3 of[kCorners];
};

/// Corners of one edge or triangle per lane.
template <std::size_t kCorners>
struct Ends {
  static constexpr std::size_t kCount = kCorners;
  Corners<kCorners> positions;
  Corners<kCorners> normals;
};

struct Point {
  V3 position;
  V3 normal;
};

template <std::size_t kCorners>
HWY_INLINE V3 weightedSum(const Corners<kCorners>& corners, const Weights& w) {
  V3 sum = V3{zero(), zero(), zero()} + w.u * corners.of[0] + w.v * corners.of[1];
  if constexpr (kCorners == 3) sum = sum + w.s * corners.of[2];
  return sum;
}

/// Value at the corner with the largest weight, the first if several are equal.
template <std::size_t kCorners>
HWY_INLINE V3 heaviest(const Corners<kCorners>& corners, const Weights& w) {
  const M first = both(hn::Ge(w.u, w.v), hn::Ge(w.u, w.s));
  V3 others = corners.of[1];
  if constexpr (kCorners == 3) others = select(hn::Ge(w.v, w.s), corners.of[1], corners.of[2]);
  return select(first, corners.of[0], others);
}

template <std::size_t kCorners>
HWY_INLINE V3 phongNormal(const Corners<kCorners>& normals, const Weights& w) {
  return normalizeOr(weightedSum(normals, w), heaviest(normals, w));
}

template <std::size_t kCorners>
struct FlatPatch {
  explicit FlatPatch(const Ends<kCorners>& of) : ends(of) {}

  HWY_INLINE Point at(const Weights& w) const { return {weightedSum(ends.positions, w), phongNormal(ends.normals, w)}; }

  const Ends<kCorners>& ends;
};

/// Phong tessellation: a point pulled towards the mean of its projections onto the corners' tangent planes.
template <std::size_t kCorners>
struct PhongPatch {
  explicit PhongPatch(const Ends<kCorners>& of) : ends(of) {}

  HWY_INLINE Point at(const Weights& w) const {
    constexpr float kAlpha = 0.75f;
    const V3 flat = weightedSum(ends.positions, w);
    Corners<kCorners> onPlanes;
    for (std::size_t i = 0; i < kCorners; ++i) {
      const V3& normal = ends.normals.of[i];
      onPlanes.of[i] = flat - dot(flat - ends.positions.of[i], normal) * normal;
    }
    return {flat * all(1.0f - kAlpha) + weightedSum(onPlanes, w) * all(kAlpha), phongNormal(ends.normals, w)};
  }

  const Ends<kCorners>& ends;
};

/// Spherigon: mean of the points on the spheres through each corner, along the Phong normal.
template <std::size_t kCorners>
struct SpherigonPatch {
  explicit SpherigonPatch(const Ends<kCorners>& of) : ends(of) {}

  HWY_INLINE Point at(const Weights& w) const {
    const V3 flat = weightedSum(ends.positions, w);
    const V3 normal = phongNormal(ends.normals, w);
    const V weights[3] = {w.u, w.v, w.s};
    V height = zero();
    V sum = zero();
    for (std::size_t i = 0; i < kCorners; ++i) {
      const V3& own = ends.normals.of[i];
      // 1 + N.Ni goes to 0 for opposite normals, which have no such sphere.
      const V between = all(1.0f) + dot(normal, own);
      const V along = select(hn::Lt(between, all(0.1f)), all(0.1f), between);
      const V squared = weights[i] * weights[i];
      height = height + squared * dot(ends.positions.of[i] - flat, normal + own) / along;
      sum = sum + squared;
    }
    return {flat + normal * (height / sum), normal};
  }

  const Ends<kCorners>& ends;
};

/// Tangent control point a third of the way from a to b, moved into a's tangent plane.
template <std::size_t kCorners>
HWY_INLINE V3 pnTangentPoint(const Ends<kCorners>& ends, std::size_t a, std::size_t b) {
  const V3& from = ends.positions.of[a];
  const V3& to = ends.positions.of[b];
  const V3& normal = ends.normals.of[a];
  return (all(2.0f) * from + to - dot(to - from, normal) * normal) / all(3.0f);
}

/// Mid-edge normal: the mean reflected in the plane across the edge, so that inflections show.
template <std::size_t kCorners>
HWY_INLINE V3 pnEdgeNormal(const Ends<kCorners>& ends, std::size_t a, std::size_t b) {
  const V3 along = ends.positions.of[b] - ends.positions.of[a];
  const V3 sum = ends.normals.of[a] + ends.normals.of[b];
  const V squared = dot(along, along);
  const V v = select(hn::Gt(squared, zero()), all(2.0f) * dot(along, sum) / squared, zero());
  return normalizeOr(sum - v * along, ends.normals.of[a]);
}

struct PnEdge {
  explicit PnEdge(const Ends<2>& of)
      : ends(of), b21(pnTangentPoint(of, 0, 1)), b12(pnTangentPoint(of, 1, 0)), n11(pnEdgeNormal(of, 0, 1)) {}

  HWY_INLINE Point at(const Weights& w) const {
    const V u = w.u;
    const V v = w.v;
    const V3 position = ends.positions.of[0] * (u * u * u) + b21 * (all(3.0f) * u * u * v) +
                        b12 * (all(3.0f) * u * v * v) + ends.positions.of[1] * (v * v * v);
    const V3 normal = ends.normals.of[0] * (u * u) + n11 * (u * v) + ends.normals.of[1] * (v * v);
    return {position, normalizeOr(normal, heaviest(ends.normals, w))};
  }

  const Ends<2>& ends;
  V3 b21;
  V3 b12;
  V3 n11;
};

struct PnTriangle {
  explicit PnTriangle(const Ends<3>& of)
      : ends(of),
        b210(pnTangentPoint(of, 0, 1)),
        b120(pnTangentPoint(of, 1, 0)),
        b021(pnTangentPoint(of, 1, 2)),
        b012(pnTangentPoint(of, 2, 1)),
        b102(pnTangentPoint(of, 2, 0)),
        b201(pnTangentPoint(of, 0, 2)),
        n110(pnEdgeNormal(of, 0, 1)),
        n011(pnEdgeNormal(of, 1, 2)),
        n101(pnEdgeNormal(of, 2, 0)) {
    const V3(&p)[3] = ends.positions.of;
    const V3 edgeMean = (b210 + b120 + b021 + b012 + b102 + b201) / all(6.0f);
    const V3 cornerMean = (p[0] + p[1] + p[2]) / all(3.0f);
    b111 = edgeMean + (edgeMean - cornerMean) * all(0.5f);
  }

  HWY_INLINE Point at(const Weights& w) const {
    const V u = w.u;
    const V v = w.v;
    const V s = w.s;
    const V3(&p)[3] = ends.positions.of;
    const V3(&n)[3] = ends.normals.of;
    const V3 position = p[0] * (u * u * u) + p[1] * (v * v * v) + p[2] * (s * s * s) +
                        (b210 * (u * u * v) + b120 * (u * v * v) + b021 * (v * v * s) + b012 * (v * s * s) +
                         b102 * (u * s * s) + b201 * (u * u * s)) *
                            all(3.0f) +
                        b111 * (all(6.0f) * u * v * s);
    const V3 normal =
        n[0] * (u * u) + n[1] * (v * v) + n[2] * (s * s) + n110 * (u * v) + n011 * (v * s) + n101 * (u * s);
    return {position, normalizeOr(normal, heaviest(ends.normals, w))};
  }

  const Ends<3>& ends;
  V3 b210, b120, b021, b012, b102, b201, b111;
  V3 n110, n011, n101;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
