// core/lanes/lane_doubles.h: eight numbers in double precision, for vectors of any width up to that.
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

namespace sinew {

inline constexpr std::size_t kDoubleLanes = 8;

/// One number a lane.
struct alignas(64) LaneDoubles {
  std::array<double, kDoubleLanes> lane;

  [[nodiscard]] const double* at(std::size_t first) const { return lane.data() + first; }
};

/// One point or direction a lane.
struct LaneVectors {
  LaneDoubles x;
  LaneDoubles y;
  LaneDoubles z;

  void set(std::size_t lane, const glm::dvec3& v) {
    x.lane[lane] = v.x;
    y.lane[lane] = v.y;
    z.lane[lane] = v.z;
  }
};

}  // namespace sinew
