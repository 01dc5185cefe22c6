// core/surface/roots/lane_terms.h: the field along 16 rays that meet the same primitives, one lane per ray.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/geometry/lane_floats.h"
#include "core/surface/roots/lane_cliques.h"
#include "sinew/geometry/shape.h"

namespace sinew {

/// One ellipsoid's potential along each ray: w(t) = peak - a (t - middle)^2, f(t) = factor max(0, w)^2. It is written
/// about the peak because c - b^2 / a would cancel for a small primitive far along the ray.
struct LaneTerm {
  LaneFloats a;
  LaneFloats middle;
  LaneFloats peak;
  LaneFloats factor;    ///< sign * s_i * m_i; 0 if the ray's vertex does not see the primitive.
  float groove = 0.0f;  ///< PosedPrimitive::groove
  int primitive = 0;
  int slot = 0;  ///< Group slot, or kEverySum: part of every clique's sum (carves).

  static constexpr int kEverySum = kInEveryClique;
};

/// The same for a shaped primitive, whose w = 1 - r^2 is no quadratic: the lines in its unit space, point + s along,
/// with s = 0 where each is closest to the primitive's center.
struct LaneShape {
  const UnitShape* unit = nullptr;
  int primitive = 0;
  int slot = 0;
  float groove = 0.0f;
  float way = 1.0f;    ///< s = way t - middle. 1: rays run along the lines; -1: against them.
  float sense = 1.0f;  ///< Multiplies the factor.
  LaneFloats middle;
  LaneFloats factor;  ///< Also 0 if the ray misses the shape's box.
  std::array<LaneFloats, 3> point;
  std::array<LaneFloats, 3> along;  ///< Per world unit.
  LaneFloats enter;                 ///< s where the line enters the shape's box, which holds all of it,
  LaneFloats leave;                 ///< and where it leaves the box.
  LaneFloats turnX;                 ///< s where the offsets from a bent axis have an extremum.
  LaneFloats turnZ;
};

/// Sums of one group, a lane per ray. Their meaning is up to the caller.
struct SlotSums {
  std::array<LaneFloats, 9> of;
  LaneFloats share;  ///< m_j of GroupBlend.
  LaneFloats top;    ///< Level of core/geometry/formulas/potential.h.
  LaneFloats inverse;
};

/// Reused from tile to tile, so that nothing is allocated; carries nothing over. One per thread.
struct LaneScratch {
  std::vector<LaneTerm> terms;
  std::size_t termCount = 0;
  std::vector<LaneShape> shapes;
  std::size_t shapeCount = 0;
  std::vector<SlotSums> sums;
  std::vector<LaneLevel> levels;  ///< Of the tile.
  PresentCliques present;
  std::vector<LaneFloats> shares;  ///< Of each clique; negative: it takes no part.
  std::vector<int> sharing;        ///< Cliques that may have a share in some lane.
};

}  // namespace sinew
