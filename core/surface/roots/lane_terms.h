// core/surface/roots/lane_terms.h: the field along 16 rays that meet the same primitives, a lane per ray.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/lane_floats.h"
#include "sinew/geometry/shape.h"

namespace sinew {

/// One ellipsoid's potential along each ray: w(t) = peak - a (t - middle)^2, f(t) = factor max(0, w)^2.
/// Written about its peak: c - b^2 / a would cancel for a small primitive far along the ray.
struct LaneTerm {
  LaneFloats a;
  LaneFloats middle;
  LaneFloats peak;
  LaneFloats factor;  ///< sign * s_i * m_i; 0 where a ray's vertex does not see the primitive.
  int primitive = 0;
  int slot = 0;  ///< Group slot, or kEverySum: counts in every clique (carves).

  static constexpr int kEverySum = -1;
};

/// The same of a shaped primitive, whose w = 1 - r^2 is no quadratic: its lines in its unit space, point + s along, s
/// from where each is closest to the primitive's center.
struct LaneShape {
  const UnitShape* unit = nullptr;
  int primitive = 0;
  int slot = 0;
  float way = 1.0f;    ///< 1: rays run along the lines, -1: against them: s = way t - middle.
  float sense = 1.0f;  ///< Times the factor.
  LaneFloats middle;
  LaneFloats factor;  ///< 0 also where a ray does not meet the shape's box.
  std::array<LaneFloats, 3> point;
  std::array<LaneFloats, 3> along;  ///< Per world unit.
  LaneFloats enter;                 ///< s where the line enters the shape's box, beyond which nothing of it is ...
  LaneFloats leave;                 ///< ... and leaves it.
  LaneFloats turnX;                 ///< s where the offsets from a bent axis turn.
  LaneFloats turnZ;
};

/// Sums of one group, a lane per ray. What they are sums of is the reader's to say.
struct SlotSums {
  std::array<LaneFloats, 5> of;
};

/// Which slots add up: cliques[begin[k] .. begin[k+1]); none: everything sums.
struct LaneCliques {
  std::span<const int> begin;
  std::span<const int> slots;
  std::size_t slotCount = 0;

  [[nodiscard]] bool empty() const { return begin.size() < 2; }
  [[nodiscard]] std::size_t count() const { return empty() ? 0 : begin.size() - 1; }
};

/// Reused from tile to tile, so that nothing is allocated; carries nothing from one to the next. One a thread.
struct LaneScratch {
  std::vector<LaneTerm> terms;
  std::size_t termCount = 0;
  std::vector<LaneShape> shapes;
  std::size_t shapeCount = 0;
  std::vector<SlotSums> sums;
};

}  // namespace sinew
