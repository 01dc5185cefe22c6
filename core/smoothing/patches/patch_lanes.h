// core/smoothing/patches/patch_lanes.h: the formulas of the four patches, an edge or a triangle a lane. Included once
// per instruction set.
#if defined(SINEW_PATCH_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_PATCH_LANES_H
#undef SINEW_PATCH_LANES_H
#else
#define SINEW_PATCH_LANES_H
#endif

#include <array>
#include <cstddef>

#include "core/lanes/lane_rows.h"
#include "hwy/highway.h"
#include "sinew/rig/rig.h"
#include "sinew/smoothing/refinement.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Barycentric, the same in every lane; an edge's third is 0.
struct Weights {
  float u;
  float v;
  float s;

  /// The corner with the largest; the first of equal ones.
  [[nodiscard]] std::size_t heaviest() const {
    if (u >= v && u >= s) return 0;
    return v >= s ? 1 : 2;
  }
};

/// Numbers of one corner after the other.
template <std::size_t kCorners>
struct Corners {
  V3 of[kCorners];
};

/// Corners of one edge or triangle a lane.
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
  V3 sum = V3{zero(), zero(), zero()} + all(w.u) * corners.of[0] + all(w.v) * corners.of[1];
  if constexpr (kCorners == 3) sum = sum + all(w.s) * corners.of[2];
  return sum;
}

template <std::size_t kCorners>
HWY_INLINE V3 phongNormal(const Corners<kCorners>& normals, const Weights& w) {
  return normalizeOr(weightedSum(normals, w), normals.of[w.heaviest()]);
}

template <std::size_t kCorners>
struct FlatPatch {
  explicit FlatPatch(const Ends<kCorners>& of) : ends(of) {}

  HWY_INLINE Point at(const Weights& w) const { return {weightedSum(ends.positions, w), phongNormal(ends.normals, w)}; }

  const Ends<kCorners>& ends;
};

/// Phong tessellation: pulled towards the mean of its projections on the corners' tangent planes.
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
    const float weights[3] = {w.u, w.v, w.s};
    V height = zero();
    float sum = 0.0f;
    for (std::size_t i = 0; i < kCorners; ++i) {
      const V3& own = ends.normals.of[i];
      // 1 + N.Ni goes to 0 for opposite normals, where no such sphere exists.
      const V between = all(1.0f) + dot(normal, own);
      const V along = select(hn::Lt(between, all(0.1f)), all(0.1f), between);
      const float squared = weights[i] * weights[i];
      height = height + all(squared) * dot(ends.positions.of[i] - flat, normal + own) / along;
      sum += squared;
    }
    return {flat + normal * (height / all(sum)), normal};
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
    const float u = w.u;
    const float v = w.v;
    const V3 position = ends.positions.of[0] * all(u * u * u) + b21 * all(3.0f * u * u * v) +
                        b12 * all(3.0f * u * v * v) + ends.positions.of[1] * all(v * v * v);
    const V3 normal = ends.normals.of[0] * all(u * u) + n11 * all(u * v) + ends.normals.of[1] * all(v * v);
    return {position, normalizeOr(normal, ends.normals.of[w.heaviest()])};
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
    const auto& [u, v, s] = w;
    const V3(&p)[3] = ends.positions.of;
    const V3(&n)[3] = ends.normals.of;
    const V3 position = p[0] * all(u * u * u) + p[1] * all(v * v * v) + p[2] * all(s * s * s) +
                        (b210 * all(u * u * v) + b120 * all(u * v * v) + b021 * all(v * v * s) + b012 * all(v * s * s) +
                         b102 * all(u * s * s) + b201 * all(u * u * s)) *
                            all(3.0f) +
                        b111 * all(6.0f * u * v * s);
    const V3 normal = n[0] * all(u * u) + n[1] * all(v * v) + n[2] * all(s * s) + n110 * all(u * v) +
                      n011 * all(v * s) + n101 * all(u * s);
    return {position, normalizeOr(normal, n[w.heaviest()])};
  }

  const Ends<3>& ends;
  V3 b210, b120, b021, b012, b102, b201, b111;
  V3 n110, n011, n101;
};

/// Weights of the refined vertices on an edge, or inside a triangle.
template <std::size_t kCorners>
struct Lattice {
  explicit Lattice(const Refinement& refinement) {
    const float n = static_cast<float>(refinement.depth);
    if constexpr (kCorners == 2) {
      for (int step = 1; step < refinement.depth; ++step) {
        const float w = static_cast<float>(step) / n;
        at[count++] = {1.0f - w, w, 0.0f};
      }
    } else {
      for (const auto& [j, k] : refinement.interior) {
        at[count++] = {static_cast<float>(refinement.depth - j - k) / n, static_cast<float>(j) / n,
                       static_cast<float>(k) / n};
      }
    }
  }

  std::size_t count = 0;
  std::array<Weights, (kMaxDepth - 1) * (kMaxDepth - 2) / 2> at;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
