// core/geometry/lane_points.h: vectors in space, a lane each. Included once per instruction set.
#if defined(SINEW_LANE_POINTS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANE_POINTS_H
#undef SINEW_LANE_POINTS_H
#else
#define SINEW_LANE_POINTS_H
#endif

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include <glm/mat3x3.hpp>

#include "core/geometry/lanes.h"
#include "sinew/geometry/geometry.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

struct V3 {
  V x;
  V y;
  V z;

  friend HWY_INLINE V3 operator+(const V3& a, const V3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend HWY_INLINE V3 operator-(const V3& a, const V3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend HWY_INLINE V3 operator*(V s, const V3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend HWY_INLINE V3 operator*(const V3& a, V s) { return s * a; }
  friend HWY_INLINE V3 operator/(const V3& a, V s) { return {a.x / s, a.y / s, a.z / s}; }
};

HWY_INLINE V dot(const V3& a, const V3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE V3 cross(const V3& a, const V3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE V3 all(const glm::vec3& v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE V3 times(const glm::mat3& m, const V3& v) { return v.x * all(m[0]) + v.y * all(m[1]) + v.z * all(m[2]); }
HWY_INLINE V3 transposedTimes(const glm::mat3& m, const V3& v) {
  return {dot(all(m[0]), v), dot(all(m[1]), v), dot(all(m[2]), v)};
}
HWY_INLINE V3 select(M mask, const V3& yes, const V3& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

/// As normalizeOr of base/geometry.h, for lengths that a float's square holds; `fallback` for others.
HWY_INLINE V3 unitOr(const V3& v, const V3& fallback) {
  const V squared = dot(v, v);
  const M usual = both(hn::Gt(squared, all(1e-20f)), hn::Lt(squared, all(1e20f)));
  return select(usual, (all(1.0f) / hn::Sqrt(squared)) * v, fallback);
}

/// Points or directions of a tile's lanes.
struct LanePoints {
  LaneFloats x;
  LaneFloats y;
  LaneFloats z;

  /// The lanes from `first` on, as many as a vector holds.
  void gather(std::span<const glm::vec3> from, const std::array<int, kLanes>& vertices, std::size_t first) {
    for (std::size_t lane = first; lane < first + width(); ++lane) {
      set(lane, from[static_cast<std::size_t>(vertices[lane])]);
    }
  }
  void set(std::size_t lane, const glm::vec3& v) {
    x.lane[lane] = v.x;
    y.lane[lane] = v.y;
    z.lane[lane] = v.z;
  }
  [[nodiscard]] glm::vec3 at(std::size_t lane) const { return {x.lane[lane], y.lane[lane], z.lane[lane]}; }
  HWY_INLINE V3 load(std::size_t first) const {
    return {hn::Load(kTag, x.at(first)), hn::Load(kTag, y.at(first)), hn::Load(kTag, z.at(first))};
  }
  HWY_INLINE void store(const V3& v, std::size_t first) {
    hn::Store(v.x, kTag, x.at(first));
    hn::Store(v.y, kTag, y.at(first));
    hn::Store(v.z, kTag, z.at(first));
  }
};

inline HWY_NOINLINE V3 normalizeLaneByLane(const V3& v, const V3& fallback) {
  LanePoints units;
  LanePoints fallbacks;
  units.store(v, 0);
  fallbacks.store(fallback, 0);
  for (std::size_t lane = 0; lane < width(); ++lane) {
    units.set(lane, sinew::normalizeOr(units.at(lane), fallbacks.at(lane)));
  }
  return units.load(0);
}

/// As normalizeOr of base/geometry.h, bit for bit. Fast where a float's square holds all lengths.
HWY_INLINE V3 normalizeOr(const V3& v, const V3& fallback) {
  const V squared = dot(v, v);
  const M usual = both(hn::Gt(squared, all(1e-20f)), hn::Lt(squared, all(1e20f)));
  if (HWY_UNLIKELY(!hn::AllTrue(kTag, usual))) return normalizeLaneByLane(v, fallback);
  return v / hn::Sqrt(squared);
}

/// Calls visit(lane) for every lane of the mask, whose lanes are those from `first` on.
template <class Visit>
HWY_INLINE void forEach(M mask, std::size_t first, Visit visit) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(kTag, mask, reinterpret_cast<std::uint8_t*>(&bits));
  for (; bits != 0; bits &= bits - 1) visit(first + static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
