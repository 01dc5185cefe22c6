// core/files/fit/fit_kernel.cpp: sums over poses, compiled once per instruction set; all sets give the same bits.
#include "core/files/fit/weight_fit.h"

#include <algorithm>

#include "core/geometry/at.h"
#include "core/geometry/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/files/fit/fit_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::exporting::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<double, kHelperGroup> kDoubles;
using D = hn::VFromD<decltype(kDoubles)>;
static_assert(kMostCandidates % kHelperGroup == 0);

HWY_INLINE std::size_t doubles() { return hn::Lanes(kDoubles); }

HWY_INLINE D all(double value) { return hn::Set(kDoubles, value); }

/// Three coordinates a lane.
struct D3 {
  D x, y, z;
};

HWY_INLINE D dot(const D3& a, const D3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

/// Up to kMostCandidates vectors.
struct Ways {
  alignas(64) double x[kMostCandidates] = {};
  alignas(64) double y[kMostCandidates] = {};
  alignas(64) double z[kMostCandidates] = {};

  [[nodiscard]] HWY_INLINE D3 at(std::size_t first) const {
    return {hn::Load(kDoubles, x + first), hn::Load(kDoubles, y + first), hn::Load(kDoubles, z + first)};
  }
};

/// Vectors from the live vertex to its position by each candidate alone.
HWY_INLINE void findWays(const PoseToFit& pose, std::span<const int> list, const glm::dvec3& rest, std::size_t v,
                         Ways& ways) {
  const glm::dvec3 live(pose.live[v]);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const glm::dvec3 way = carryPoint(sinew::at(pose.matrices, list[i]), rest) - live;
    ways.x[i] = way.x;
    ways.y[i] = way.y;
    ways.z[i] = way.z;
  }
}

/// Rows of kMostCandidates; entries beyond the diagonal are not read.
using Rows = double[kMostCandidates * kMostCandidates];

HWY_INLINE void addPose(const Ways& ways, std::size_t count, Rows& rows) {
  for (std::size_t i = 0; i < count; ++i) {
    const D3 way{all(ways.x[i]), all(ways.y[i]), all(ways.z[i])};
    for (std::size_t k = 0; k <= i; k += doubles()) {
      double* const sums = rows + i * kMostCandidates + k;
      hn::Store(hn::Load(kDoubles, sums) + dot(way, ways.at(k)), kDoubles, sums);
    }
  }
}

void addGrams(const GramSums& sums, std::size_t first, std::size_t end) {
  alignas(64) Rows rows[2] = {};  // Own, further.
  double* const kept[2] = {sums.own, sums.further};
  Ways ways;
  for (std::size_t v = first; v < end; ++v) {
    const std::vector<int>& list = sums.lists[v];
    for (std::size_t kind = 0; kind < 2; ++kind) {
      const double* from = kept[kind] + sums.begin[v];
      for (std::size_t i = 0; i < list.size(); from += ++i) std::copy_n(from, i + 1, rows[kind] + i * kMostCandidates);
    }
    const glm::dvec3 rest(sums.rest[v]);
    for (const PoseToFit& pose : sums.poses) {
      findWays(pose, list, rest, v, ways);
      addPose(ways, list.size(), rows[pose.further ? 1 : 0]);
    }
    for (std::size_t kind = 0; kind < 2; ++kind) {
      double* to = kept[kind] + sums.begin[v];
      for (std::size_t i = 0; i < list.size(); to += ++i) std::copy_n(rows[kind] + i * kMostCandidates, i + 1, to);
    }
  }
}

/// The first three rows of a matrix per lane.
struct Helpers {
  const double* numbers;  ///< [4][3][stride]
  std::size_t stride;

  [[nodiscard]] HWY_INLINE D3 column(std::size_t c, std::size_t first) const {
    const double* const from = numbers + 3 * c * stride + first;
    return {hn::LoadU(kDoubles, from), hn::LoadU(kDoubles, from + stride), hn::LoadU(kDoubles, from + 2 * stride)};
  }
};

void addGains(const GainSums& sums, std::size_t first, std::size_t end) {
  for (std::size_t v = first; v < end; ++v) {
    const glm::dvec3 rest(sums.rest[v]);
    for (std::size_t f = 0; f < sums.poses.size(); ++f) {
      const PoseToFit& pose = sums.poses[f];
      if (pose.further) continue;
      const glm::dvec3 now = skinPoint(pose.matrices, sums.weights[v], rest);
      const glm::dvec3 left = glm::dvec3(pose.live[v]) - now;
      const D3 off{all(left.x), all(left.y), all(left.z)};
      const Helpers helpers{sums.helpers + 12 * sums.stride * f, sums.stride};
      for (std::size_t h = 0; h < sums.stride; h += doubles()) {
        const D3 a = helpers.column(0, h), b = helpers.column(1, h), c = helpers.column(2, h), d = helpers.column(3, h);
        const D x = all(rest.x), y = all(rest.y), z = all(rest.z);
        const D3 way{((a.x * x + b.x * y) + (c.x * z + d.x)) - all(now.x),
                     ((a.y * x + b.y * y) + (c.y * z + d.y)) - all(now.y),
                     ((a.z * x + b.z * y) + (c.z * z + d.z)) - all(now.z)};
        double* const toward = sums.toward + v * sums.stride + h;
        double* const length = sums.length + v * sums.stride + h;
        hn::StoreU(hn::LoadU(kDoubles, toward) + dot(off, way), kDoubles, toward);
        hn::StoreU(hn::LoadU(kDoubles, length) + dot(way, way), kDoubles, length);
      }
    }
  }
}

constexpr FitKernels kKernels{&addGrams, &addGains};

}  // namespace sinew::exporting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew::exporting {

FitKernels fitKernels(InstructionSet set) { SINEW_RETURN_BY_SET(set, kKernels) }

}  // namespace sinew::exporting
#endif
