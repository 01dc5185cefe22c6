// core/geometry/lane_floats.h: sixteen numbers, for SIMD vectors of any width up to that.
#pragma once

#include <array>
#include <cstddef>

namespace sinew {

inline constexpr std::size_t kLanes = 16;

struct alignas(64) LaneFloats {
  std::array<float, kLanes> lane;

  [[nodiscard]] float* at(std::size_t first) { return lane.data() + first; }
  [[nodiscard]] const float* at(std::size_t first) const { return lane.data() + first; }
};

}  // namespace sinew
