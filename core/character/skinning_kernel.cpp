// core/character/skinning_kernel.cpp: vertices follow their bones, compiled once per instruction set. Every lane does
// the operations of skinning.cpp in the same order.
#include "core/character/skinning_kernel.h"

#include <algorithm>

#include "core/base/at.h"
#include "core/lanes/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/character/skinning_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/lanes/lane_rows.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

constexpr std::size_t kNumbers = 16;  ///< Of a matrix, column by column.

/// The weighted sum of a vertex's matrices, with as few vectors as hold it.
HWY_INLINE void blend(std::span<const Influence> influences, const glm::mat4* matrices, float* to) {
  static_assert(sizeof(glm::mat4) == kNumbers * sizeof(float) && kNumbers == kLanes);
  for (std::size_t i = 0; i < kNumbers; i += width()) {
    V sum = zero();
    for (const auto& [binding, weight] : influences) {
      sum = sum + hn::LoadU(kTag, &matrices[binding][0][0] + i) * all(weight);
    }
    hn::Store(sum, kTag, to + i);
  }
}

/// The first three rows of a matrix a lane.
struct LaneMatrix {
  V3 column[4];
};

HWY_INLINE V3 cross(const V3& a, const V3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// As normalMatrix of base/geometry.h carries it.
HWY_INLINE V3 carried(const V3& direction, const LaneMatrix& matrix) {
  const V3(&m)[4] = matrix.column;
  const V3 cofactors[3] = {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
  const V sign = choose(hn::Lt(dot(m[0], cofactors[0]), zero()), all(-1.0f), all(1.0f));
  const V3 sum =
      (sign * cofactors[0]) * direction.x + (sign * cofactors[1]) * direction.y + (sign * cofactors[2]) * direction.z;
  return normalizeOr(sum, direction);
}

HWY_INLINE V3 moved(const V3& point, const LaneMatrix& matrix) {
  const V3(&m)[4] = matrix.column;
  return (m[0] * point.x + m[1] * point.y) + (m[2] * point.z + m[3]);
}

class Skinner {
 public:
  explicit Skinner(const SkinFrame& frame)
      : frame_(frame), positions_(frame.mesh->positions), directions_(frame.directions) {}

  /// Vertices from `first` on, as many as there are lanes; lanes beyond the last vertex repeat it.
  void skin(int first) {
    const int last = static_cast<int>(frame_.directions.size()) - 1;
    const auto used = std::min(width(), toIndex(last - first + 1));
    const auto vertex = [&](std::size_t lane) { return std::min(first + static_cast<int>(lane), last); };
    for (std::size_t lane = 0; lane < width(); ++lane) {
      blend(frame_.mesh->influencesOf(vertex(lane)), frame_.matrices.data(), blended_ + lane * kNumbers);
    }
    LaneMatrix matrix;
    for (std::size_t c = 0; c < 4; ++c) {
      matrix.column[c] = gatheredBy([&](std::size_t lane) { return blended_ + lane * kNumbers + 4 * c; });
    }
    if (!frame_.outPositions.empty()) {
      const V3 point = gatheredBy([&](std::size_t lane) { return positions_.at(vertex(lane)); });
      scatter(moved(point, matrix), &at(frame_.outPositions, first), 1, used);
    }
    const V3 direction = gatheredBy([&](std::size_t lane) { return directions_.at(vertex(lane)); });
    scatter(carried(direction, matrix), &at(frame_.outDirections, first), 1, used);
  }

 private:
  const SkinFrame& frame_;
  Rows positions_;
  Rows directions_;
  alignas(64) float blended_[kLanes * kNumbers];
};

void skinAll(const SkinFrame& frame) {
  Skinner skinner(frame);
  const int count = static_cast<int>(frame.directions.size());
  for (int first = 0; first < count; first += static_cast<int>(width())) skinner.skin(first);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {

SkinKernel skinKernel(InstructionSet set) {
  switch (set) {
#if HWY_TARGETS & HWY_AVX3
    case InstructionSet::kAvx512:
      return &N_AVX3::skinAll;
#endif
#if HWY_TARGETS & HWY_AVX2
    case InstructionSet::kAvx2:
      return &N_AVX2::skinAll;
#endif
#if HWY_TARGETS & HWY_SSE4
    case InstructionSet::kSse4:
      return &N_SSE4::skinAll;
#endif
    default:
      return &HWY_STATIC_DISPATCH(skinAll);
  }
}

}  // namespace sinew
#endif
