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

#define formula HWY_INLINE
#define precise
#include "core/geometry/formulas/patch.h"
#undef precise
#undef formula

template <std::size_t kCorners>
HWY_INLINE V3 weightedSum(const Corners<kCorners>& corners, const Weights& w) {
  const V3(&of)[kCorners] = corners.of;
  if constexpr (kCorners == 3) return weighted(of[0], of[1], of[2], w.u, w.v, w.s);
  else return weighted(of[0], of[1], w.u, w.v);
}

template <std::size_t kCorners>
HWY_INLINE V3 phongNormal(const Corners<kCorners>& normals, const Weights& w) {
  const V3(&of)[kCorners] = normals.of;
  if constexpr (kCorners == 3) return direction(of[0], of[1], of[2], w.u, w.v, w.s);
  else return direction(of[0], of[1], w.u, w.v);
}

template <std::size_t kCorners>
struct FlatPatch {
  explicit FlatPatch(const Ends<kCorners>& of) : ends(of) {}

  HWY_INLINE Point at(const Weights& w) const { return {weightedSum(ends.positions, w), phongNormal(ends.normals, w)}; }

  const Ends<kCorners>& ends;
};

template <std::size_t kCorners>
struct PhongPatch {
  explicit PhongPatch(const Ends<kCorners>& of) : ends(of) {}

  HWY_INLINE Point at(const Weights& w) const {
    const V3 flat = weightedSum(ends.positions, w);
    Corners<kCorners> onPlanes;
    for (std::size_t i = 0; i < kCorners; ++i) {
      onPlanes.of[i] = onPlane(flat, ends.positions.of[i], ends.normals.of[i]);
    }
    return {phongPoint(flat, weightedSum(onPlanes, w)), phongNormal(ends.normals, w)};
  }

  const Ends<kCorners>& ends;
};

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
      const V squared = weights[i] * weights[i];
      height = height + sphereHeight(squared, flat, normal, ends.positions.of[i], ends.normals.of[i]);
      sum = sum + squared;
    }
    return {flat + normal * (height / sum), normal};
  }

  const Ends<kCorners>& ends;
};

struct PnEdgePatch {
  explicit PnEdgePatch(const Ends<2>& of)
      : ends(of), inner(pnEdge(of.positions.of[0], of.positions.of[1], of.normals.of[0], of.normals.of[1])) {}

  HWY_INLINE Point at(const Weights& w) const {
    const V3(&p)[2] = ends.positions.of;
    const V3(&n)[2] = ends.normals.of;
    return {pnPosition(inner, p[0], p[1], w.u, w.v), pnNormal(inner, n[0], n[1], w.u, w.v)};
  }

  const Ends<2>& ends;
  PnEdge inner;
};

struct PnTrianglePatch {
  explicit PnTrianglePatch(const Ends<3>& of)
      : ends(of),
        inner(pnTriangle(of.positions.of[0], of.positions.of[1], of.positions.of[2], of.normals.of[0], of.normals.of[1],
                         of.normals.of[2])) {}

  HWY_INLINE Point at(const Weights& w) const {
    const V3(&p)[3] = ends.positions.of;
    const V3(&n)[3] = ends.normals.of;
    return {pnPosition(inner, p[0], p[1], p[2], w.u, w.v, w.s), pnNormal(inner, n[0], n[1], n[2], w.u, w.v, w.s)};
  }

  const Ends<3>& ends;
  PnTriangle inner;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
