// core/lines/line_pose_kernel.cpp: the virtual bone that two anchors span, a line a lane, compiled once per instruction
// set.
#include <cstddef>
#include <cstring>
#include <type_traits>

#include "core/lanes/targets.h"
#include "core/lines/line_block.h"
#include "core/lines/line_pose.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lines/line_pose_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/lines/line_formulas.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

constexpr double kOpposite = 1e-6;   // 1 + cosine below which two directions are opposite.
constexpr double kSamePoint = 1e-6;  // Of the rest length: anchors that meet have no direction.
constexpr double kMostFloat = 3.4e38;

using W = hn::Vec<DoubleTag>;
using W3 = Vector3<W>;
constexpr DoubleTag kWide;
constexpr hn::Rebind<float, DoubleTag> kNarrow;

HWY_INLINE W wide(double value) { return hn::Set(kWide, value); }

/// A bone a lane: the numbers of PosedBone.
struct Bones {
  W number[24];

  [[nodiscard]] HWY_INLINE W3 column(std::size_t from) const {
    return {number[from], number[from + 1], number[from + 2]};
  }
  /// By the three columns from one number on.
  [[nodiscard]] HWY_INLINE W3 times(std::size_t from, const W3& v) const {
    return v.x * column(from) + v.y * column(from + 3) + v.z * column(from + 6);
  }
  [[nodiscard]] HWY_INLINE W3 turned(const W3& v) const { return times(PosedBone::kTurn, v); }
  [[nodiscard]] HWY_INLINE W3 inWorld(const W3& point) const {
    return times(PosedBone::kMatrix, point) + column(PosedBone::kMatrix + 9);
  }
};

/// Four numbers.
HWY_INLINE void copy(const double* from, double* to) {
  const hn::CappedTag<double, 4> row;
  for (std::size_t i = 0; i < 4; i += hn::Lanes(row)) hn::Store(hn::Load(row, from + i), row, to + i);
}

HWY_INLINE void gather(const PosedBone* bones, const int* places, Bones& out) {
  alignas(64) double rows[6][4 * kDoubleLanes];
  for (std::size_t lane = 0; lane < hn::Lanes(kWide); ++lane) {
    const double* from = bones[places[lane]].number.data();
    copy(from, rows[0] + 4 * lane);
    copy(from + 4, rows[1] + 4 * lane);
    copy(from + 8, rows[2] + 4 * lane);
    copy(from + 12, rows[3] + 4 * lane);
    copy(from + 16, rows[4] + 4 * lane);
    copy(from + 20, rows[5] + 4 * lane);
  }
  W* to = out.number;
  hn::LoadInterleaved4(kWide, rows[0], to[0], to[1], to[2], to[3]);
  hn::LoadInterleaved4(kWide, rows[1], to[4], to[5], to[6], to[7]);
  hn::LoadInterleaved4(kWide, rows[2], to[8], to[9], to[10], to[11]);
  hn::LoadInterleaved4(kWide, rows[3], to[12], to[13], to[14], to[15]);
  hn::LoadInterleaved4(kWide, rows[4], to[16], to[17], to[18], to[19]);
  hn::LoadInterleaved4(kWide, rows[5], to[20], to[21], to[22], to[23]);
}

/// The bind frame's height as one bone carries it, after the least rotation that takes the carried direction onto the
/// line: what is square to a direction loses its part along the new one in the plane of both.
HWY_INLINE W3 carriedHeight(const W3& from, const W3& height, const W3& direction) {
  const W opening = wide(1.0) + dot(from, direction);
  const W3 swung = height - (dot(height, direction) / opening) * (from + direction);
  return choose(hn::Lt(opening, wide(kOpposite)), height, swung);  // A half turn about the height: any would do.
}

/// The normalised mixture of the quaternions of two frames around one direction, as the height it gives. Half their
/// angle apart, the mixture of their half-angle vectors is the half angle from the first.
/// @param a, b  unit, square to the direction
HWY_INLINE W3 mixedHeight(const W3& a, const W3& b, const W3& direction, W share) {
  const W one = wide(1.0);
  const W half = wide(0.5);
  const W cosine = clamped(kWide, dot(a, b), -1.0, 1.0);
  const W3 beside = cross(direction, a);
  const W halfCosine = hn::Sqrt(half * (one + cosine));
  const W halfSine = hn::CopySign(hn::Sqrt(half * (one - cosine)), dot(beside, b));
  const W c = one - share + share * halfCosine;
  const W s = share * halfSine;
  const W c2 = c * c;
  const W s2 = s * s;
  const W whole = one / (c2 + s2);
  return ((c2 - s2) * whole) * a + ((c + c) * s * whole) * beside;
}

/// Lines from a block's lane `first` on, as many as a vector holds.
class LanePoser {
 public:
  LanePoser(const LineBlock& block, const LaneDoubles& flex, const PosedBone* bones, std::size_t first)
      : block_(block), flex_(flex), bones_(bones), first_(first) {}

  HWY_INLINE void pose(PosedLine* out) {
    gather(bones_, block_.originBone.data() + first_, byOrigin_);
    gather(bones_, block_.insertionBone.data() + first_, byInsertion_);
    origin_ = byOrigin_.inWorld(load(block_.origin));
    insertion_ = byInsertion_.inWorld(load(block_.insertion));
    const W3 along = insertion_ - origin_;
    const W straight = lengthOf(along);
    W length = straight;
    W moved = byOrigin_.number[PosedBone::kMoved] + byInsertion_.number[PosedBone::kMoved];
    via_ = wide(0.5) * (origin_ + insertion_);
    if (block_.hasVia) {
      Bones byVia;
      gather(bones_, block_.viaBone.data() + first_, byVia);
      via_ = byVia.inWorld(load(block_.via));
      length = lengthOf(via_ - origin_) + lengthOf(insertion_ - via_);
      moved = moved + byVia.number[PosedBone::kMoved];
    }
    const W inBind = load(block_.length);
    const auto still = hn::Eq(moved, hn::Zero(kWide));
    // Not a rounding away from it: what is at rest must be loose.
    length = hn::IfThenElse(still, inBind, length);
    scale_ = hn::Sqrt(byOrigin_.number[PosedBone::kScale] * byInsertion_.number[PosedBone::kScale]);
    restLength_ = load(block_.restLength) * scale_;
    contract(length / restLength_);
    layFrame(along, straight, inBind);
    deform();
    // Nothing has moved: what the designer drew is there, bit for bit.
    rest(hn::And(still, hn::Eq(activation_, hn::Zero(kWide))));
    write(out);
  }

 private:
  HWY_INLINE W load(const LaneDoubles& from) const { return hn::Load(kWide, from.at(first_)); }
  HWY_INLINE W3 load(const LaneVectors& from) const { return HWY_NAMESPACE::load(kWide, from, first_); }

  HWY_INLINE void contract(W stretch) {
    stretch_ = stretch;
    bellyStretch_ = bellyStretchOf(kWide, stretch, load(block_.belly));
    activation_ = activationOf(kWide, stretch, load(block_.full), load(block_.base) + load(flex_), load(block_.gain));
  }

  HWY_INLINE void layFrame(const W3& along, W straight, W inBind) {
    const W3 drawn = load(block_.direction);
    const W3 height = load(block_.height);
    const W3 fromOrigin = byOrigin_.turned(drawn);
    const W3 fromInsertion = byInsertion_.turned(drawn);
    const auto apart = hn::Gt(straight, wide(kSamePoint) * inBind);
    direction_ = choose(apart, (wide(1.0) / straight) * along, fromOrigin);
    height_ = mixedHeight(carriedHeight(fromOrigin, byOrigin_.turned(height), direction_),
                          carriedHeight(fromInsertion, byInsertion_.turned(height), direction_), direction_,
                          load(block_.twist));
    width_ = cross(direction_, height_);
  }

  HWY_INLINE void deform() {
    const W one = wide(1.0);
    const W omega = scale_ * girthOf(kWide, bellyStretch_, load(block_.exponent), load(block_.least), load(block_.most),
                                     load(block_.inBind));
    const W tendon = load(block_.tendon) * restLength_;
    const W3 direction = load(block_.direction);
    const W3 height = load(block_.height);
    const W3 width = cross(direction, height);
    const W3 ofWidth = (omega * (one + load(block_.flexWidth) * activation_)) * width;
    const W3 ofDirection = (scale_ * bellyStretch_ / load(block_.bellyStretch)) * direction;
    const W3 ofHeight = (omega * (one + load(block_.flexHeight) * activation_)) * height;
    column_[0] = ofWidth.x * width_ + ofDirection.x * direction_ + ofHeight.x * height_;
    column_[1] = ofWidth.y * width_ + ofDirection.y * direction_ + ofHeight.y * height_;
    column_[2] = ofWidth.z * width_ + ofDirection.z * direction_ + ofHeight.z * height_;
    const W3 start = load(block_.start);
    column_[3] = origin_ + tendon * direction_ - (scale_ * load(block_.depth)) * height_ -
                 (start.x * column_[0] + start.y * column_[1] + start.z * column_[2]);
    aside_ = {hn::Zero(kWide), hn::Zero(kWide), hn::Zero(kWide)};
    if (!block_.hasVia) return;
    const W3 drawn = load(block_.viaShift);
    const W3 carried = dot(width, drawn) * width_ + dot(direction, drawn) * direction_ + dot(height, drawn) * height_;
    const W belly = bellyStretch_ * load(block_.belly) * restLength_;
    aside_ = viaShiftOf(kWide, origin_, direction_, via_, tendon, belly) - scale_ * carried;
    column_[3] = column_[3] + aside_;
  }

  template <class Mask>
  HWY_INLINE void rest(Mask atRest) {
    const W zero = hn::Zero(kWide);
    const W one = wide(1.0);
    column_[0] = choose(atRest, W3{one, zero, zero}, column_[0]);
    column_[1] = choose(atRest, W3{zero, one, zero}, column_[1]);
    column_[2] = choose(atRest, W3{zero, zero, one}, column_[2]);
    column_[3] = choose(atRest, W3{zero, zero, zero}, column_[3]);
    aside_ = choose(atRest, W3{zero, zero, zero}, aside_);
  }

  static HWY_INLINE W size(const W3& v) { return hn::Abs(v.x) + hn::Abs(v.y) + hn::Abs(v.z); }

  /// 1 where the deformation is finite, else 0.
  [[nodiscard]] HWY_INLINE W usable() const {
    const W sum = (size(column_[0]) + size(column_[1])) + (size(column_[2]) + size(column_[3]));
    return hn::IfThenElseZero(hn::Lt(sum, wide(kMostFloat)), wide(1.0));
  }

  /// Four numbers of each line.
  static HWY_INLINE void put(W a, W b, W c, W d, float* to) {
    hn::StoreInterleaved4(hn::DemoteTo(kNarrow, a), hn::DemoteTo(kNarrow, b), hn::DemoteTo(kNarrow, c),
                          hn::DemoteTo(kNarrow, d), kNarrow, to);
  }

  HWY_INLINE void write(PosedLine* out) const {
    // A PosedLine is these numbers in a row.
    static_assert(
        std::is_trivially_copyable_v<PosedLine> && offsetof(PosedLine, origin) == 16 * sizeof(float) &&
        offsetof(PosedLine, via) == 19 * sizeof(float) && offsetof(PosedLine, insertion) == 22 * sizeof(float) &&
        offsetof(PosedLine, height) == 25 * sizeof(float) && offsetof(PosedLine, stretch) == 28 * sizeof(float) &&
        offsetof(PosedLine, bellyStretch) == 29 * sizeof(float) &&
        offsetof(PosedLine, activation) == 30 * sizeof(float) && offsetof(PosedLine, aside) == 31 * sizeof(float));
    constexpr std::size_t kRow = 4 * kDoubleLanes;
    alignas(64) float rows[9 * kRow];
    const W zero = hn::Zero(kWide);
    put(column_[0].x, column_[0].y, column_[0].z, zero, rows);
    put(column_[1].x, column_[1].y, column_[1].z, zero, rows + kRow);
    put(column_[2].x, column_[2].y, column_[2].z, zero, rows + 2 * kRow);
    put(column_[3].x, column_[3].y, column_[3].z, wide(1.0), rows + 3 * kRow);
    put(origin_.x, origin_.y, origin_.z, via_.x, rows + 4 * kRow);
    put(via_.y, via_.z, insertion_.x, insertion_.y, rows + 5 * kRow);
    put(insertion_.z, height_.x, height_.y, height_.z, rows + 6 * kRow);
    put(stretch_, bellyStretch_, activation_, usable(), rows + 7 * kRow);
    put(aside_.x, aside_.y, aside_.z, zero, rows + 8 * kRow);
    const std::size_t count = HWY_MIN(hn::Lanes(kWide), block_.count - first_);
    for (std::size_t lane = 0; lane < count; ++lane) {
      PosedLine& line = out[block_.line[first_ + lane]];
      const float* from = rows + 4 * lane;
      if (from[7 * kRow + 3] == 0.0f) {
        line = {};
        continue;
      }
      char* to = reinterpret_cast<char*>(&line);
      std::memcpy(to, from, 16);
      std::memcpy(to + 16, from + kRow, 16);
      std::memcpy(to + 32, from + 2 * kRow, 16);
      std::memcpy(to + 48, from + 3 * kRow, 16);
      std::memcpy(to + 64, from + 4 * kRow, 16);
      std::memcpy(to + 80, from + 5 * kRow, 16);
      std::memcpy(to + 96, from + 6 * kRow, 16);
      std::memcpy(to + 112, from + 7 * kRow, 12);
      std::memcpy(to + 124, from + 8 * kRow, 12);
      line.usable = true;
    }
  }

  const LineBlock& block_;
  const LaneDoubles& flex_;
  const PosedBone* bones_;
  std::size_t first_;
  Bones byOrigin_;
  Bones byInsertion_;
  W3 origin_;
  W3 insertion_;
  W3 via_;
  W3 direction_;
  W3 height_;
  W3 width_;
  W3 column_[4];
  W3 aside_;
  W scale_;
  W restLength_;
  W stretch_;
  W bellyStretch_;
  W activation_;
};

void poseBlocks(const PoseFrame& frame) {
  for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
    const LineBlock& block = frame.blocks[i];
    for (std::size_t first = 0; first < block.count; first += hn::Lanes(kWide)) {
      LanePoser(block, frame.flex[i], frame.bones, first).pose(frame.out);
    }
  }
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "core/lanes/dispatch.h"

namespace sinew {

LineKernel lineKernel(InstructionSet set) { SINEW_RETURN_BY_SET(set, poseBlocks) }

}  // namespace sinew
#endif
