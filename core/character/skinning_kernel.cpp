// core/character/skinning_kernel.cpp: linear blend skinning, compiled per instruction set; all sets give the same bits.
#include "core/character/skinning_kernel.h"

#include <algorithm>
#include <array>

#include "core/geometry/at.h"
#include "core/geometry/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/character/skinning_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/geometry/lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

constexpr std::size_t kNumbers = 16;  ///< Numbers of a matrix, column by column.

/// The weighted sum of a vertex's matrices, in as few SIMD vectors as possible.
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

/// The first three rows of one matrix per lane.
struct LaneMatrix {
  V3 column[4];
};

/// As by normalMatrix() of sinew/geometry/geometry.h.
HWY_INLINE V3 carry(const V3& direction, const LaneMatrix& matrix) {
  const V3(&m)[4] = matrix.column;
  const V3 cofactors[3] = {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
  const V sign = select(hn::Lt(dot(m[0], cofactors[0]), zero()), all(-1.0f), all(1.0f));
  const V3 sum =
      (sign * cofactors[0]) * direction.x + (sign * cofactors[1]) * direction.y + (sign * cofactors[2]) * direction.z;
  return normalizeOr(sum, direction);
}

HWY_INLINE V3 move(const V3& point, const LaneMatrix& matrix) {
  const V3(&m)[4] = matrix.column;
  return (m[0] * point.x + m[1] * point.y) + (m[2] * point.z + m[3]);
}

/// @param vertex  function of the lane
template <class Vertex>
HWY_INLINE LaneMatrix blendLanes(const ControlMesh& mesh, std::span<const glm::mat4> matrices, Vertex vertex) {
  alignas(64) float blended[kLanes * kNumbers];
  for (std::size_t lane = 0; lane < width(); ++lane) {
    blend(mesh.influencesOf(vertex(lane)), matrices.data(), blended + lane * kNumbers);
  }
  LaneMatrix out;
  for (std::size_t c = 0; c < 4; ++c) {
    out.column[c] = gatherBy([&](std::size_t lane) { return blended + lane * kNumbers + 4 * c; });
  }
  return out;
}

/// Lanes beyond the last vertex repeat it.
void skinVertices(const SkinInputs& inputs, std::size_t begin, std::size_t end) {
  const Rows positions(inputs.positions);
  const Rows directions(inputs.directions);
  const int count = static_cast<int>(end);
  for (int first = static_cast<int>(begin); first < count; first += static_cast<int>(width())) {
    const auto used = std::min(width(), toIndex(count - first));
    const auto vertex = [&](std::size_t lane) { return std::min(first + static_cast<int>(lane), count - 1); };
    const LaneMatrix matrix = blendLanes(*inputs.mesh, inputs.matrices, vertex);
    if (!inputs.positions.empty()) {
      const V3 point = gatherBy([&](std::size_t lane) { return positions.at(vertex(lane)); });
      scatter(move(point, matrix), &at(inputs.outPositions, first), 1, used);
    }
    const V3 direction = gatherBy([&](std::size_t lane) { return directions.at(vertex(lane)); });
    scatter(carry(direction, matrix), &at(inputs.outDirections, first), 1, used);
  }
}

/// The first `used` of the listed wedges; the others must be valid, but are not written.
void skinListed(const WedgeInputs& inputs, const std::array<std::size_t, kLanes>& listed, std::size_t used) {
  const auto wedge = [&](std::size_t lane) -> const Wedge& { return inputs.wedges[listed[lane]]; };
  const LaneMatrix matrix =
      blendLanes(*inputs.mesh, inputs.matrices, [&](std::size_t lane) { return wedge(lane).vertex; });
  LanePoints normals;
  for (std::size_t lane = 0; lane < width(); ++lane) normals.set(lane, inputs.normalOf(wedge(lane)));
  scatterTo(
      carry(normals.load(0), matrix), [&](std::size_t lane) { return &inputs.out[listed[lane]]; }, used);
}

void skinWedges(const WedgeInputs& inputs) {
  std::array<std::size_t, kLanes> listed{};
  std::size_t used = 0;
  for (std::size_t w = 0; w < inputs.wedges.size(); ++w) {
    if (!inputs.wedges[w].creased) continue;
    listed[used] = w;
    if (++used < width()) continue;
    skinListed(inputs, listed, used);
    used = 0;
  }
  if (used > 0) skinListed(inputs, listed, used);
}

constexpr SkinKernels kKernels{&skinVertices, &skinWedges};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {

SkinKernels skinKernels(InstructionSet set) { SINEW_RETURN_BY_SET(set, kKernels) }

}  // namespace sinew
#endif
