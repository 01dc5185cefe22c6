// core/geometry/lane_rows.h: vectors in space, from memory where x, y, z lie side by side into a lane each, and back.
// Included once per instruction set.
#if defined(SINEW_LANE_ROWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANE_ROWS_H
#undef SINEW_LANE_ROWS_H
#else
#define SINEW_LANE_ROWS_H
#endif

#include <array>
#include <cstddef>
#include <cstring>
#include <span>

#include <glm/vec3.hpp>

#include "core/geometry/lane_points.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Vectors that can be read as four numbers each, the fourth being any: the last one is copied, so that nothing behind
/// the span is read.
class Rows {
 public:
  explicit Rows(std::span<const glm::vec3> from) : from_(from) {
    if (!from.empty()) std::memcpy(last_, &from.back(), sizeof(glm::vec3));
  }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  [[nodiscard]] HWY_INLINE const float* at(int index) const {
    const auto i = static_cast<std::size_t>(index);
    return i + 1 < from_.size() ? &from_[i].x : last_;
  }

 private:
  std::span<const glm::vec3> from_;
  float last_[4] = {};
};

using RowPointers = std::array<const float*, kLanes>;  ///< The first width() are used.

/// Every fourth row, a block of four numbers each.
template <class Tag>
HWY_INLINE hn::Vec<Tag> everyFourth(Tag tag, const float* const* rows) {
  if constexpr (hn::MaxLanes(Tag()) == 4) {
    return hn::LoadU(tag, rows[0]);
  } else {
    const hn::Half<Tag> half;
    return hn::Combine(tag, everyFourth(half, rows + hn::MaxLanes(half)), everyFourth(half, rows));
  }
}

HWY_INLINE V3 gather(const RowPointers& rows) {
  const hn::RepartitionToWide<FloatTag> pairs;
  const V a = everyFourth(kTag, rows.data());
  const V b = everyFourth(kTag, rows.data() + 1);
  const V c = everyFourth(kTag, rows.data() + 2);
  const V d = everyFourth(kTag, rows.data() + 3);
  const auto abLow = hn::BitCast(pairs, hn::InterleaveLower(kTag, a, b));
  const auto cdLow = hn::BitCast(pairs, hn::InterleaveLower(kTag, c, d));
  const auto abHigh = hn::BitCast(pairs, hn::InterleaveUpper(kTag, a, b));
  const auto cdHigh = hn::BitCast(pairs, hn::InterleaveUpper(kTag, c, d));
  return {hn::BitCast(kTag, hn::InterleaveLower(pairs, abLow, cdLow)),
          hn::BitCast(kTag, hn::InterleaveUpper(pairs, abLow, cdLow)),
          hn::BitCast(kTag, hn::InterleaveLower(pairs, abHigh, cdHigh))};
}

/// The first `used` lanes, each to the place that place(lane) points to.
template <class Place>
HWY_INLINE void scatterTo(const V3& v, Place place, std::size_t used) {
  const hn::RepartitionToWide<FloatTag> pairs;
  const auto xyLow = hn::BitCast(pairs, hn::InterleaveLower(kTag, v.x, v.y));
  const auto xyHigh = hn::BitCast(pairs, hn::InterleaveUpper(kTag, v.x, v.y));
  const auto zLow = hn::BitCast(pairs, hn::InterleaveLower(kTag, v.z, v.z));
  const auto zHigh = hn::BitCast(pairs, hn::InterleaveUpper(kTag, v.z, v.z));
  // Lane 4 b + i in block b of row i.
  constexpr std::size_t kWidth = hn::MaxLanes(FloatTag());
  alignas(64) float rows[4 * kWidth];
  hn::Store(hn::BitCast(kTag, hn::InterleaveLower(pairs, xyLow, zLow)), kTag, rows);
  hn::Store(hn::BitCast(kTag, hn::InterleaveUpper(pairs, xyLow, zLow)), kTag, rows + kWidth);
  hn::Store(hn::BitCast(kTag, hn::InterleaveLower(pairs, xyHigh, zHigh)), kTag, rows + 2 * kWidth);
  hn::Store(hn::BitCast(kTag, hn::InterleaveUpper(pairs, xyHigh, zHigh)), kTag, rows + 3 * kWidth);
  const auto copy = [&](std::size_t lane) HWY_ATTR {
    std::memcpy(place(lane), rows + lane % 4 * kWidth + lane / 4 * 4, sizeof(glm::vec3));
  };
  std::size_t lane = 0;
  for (; lane + 4 <= used; lane += 4) {
    copy(lane);
    copy(lane + 1);
    copy(lane + 2);
    copy(lane + 3);
  }
  for (; lane < used; ++lane) copy(lane);
}

/// The first `used` lanes to every `stride`-th place from `to` on.
HWY_INLINE void scatter(const V3& v, glm::vec3* to, std::size_t stride, std::size_t used) {
  scatterTo(
      v, [=](std::size_t lane) { return to + lane * stride; }, used);
}

/// What row(lane) points to, of every lane.
template <class Row>
HWY_INLINE V3 gatherBy(Row row) {
  RowPointers rows;
  for (std::size_t lane = 0; lane < width(); ++lane) rows[lane] = row(lane);
  return gather(rows);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
