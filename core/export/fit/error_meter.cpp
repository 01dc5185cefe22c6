// core/export/fit/error_meter.cpp: distances by the leading bits of their floats.
#include "core/export/fit/error_meter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace sinew::exporting {
namespace {

constexpr unsigned kDroppedBits = 13;

}  // namespace

void ErrorMeter::add(double distance, int vertex) {
  // A NaN, which may have a sign, has no class.
  const double percent = std::isfinite(distance) ? distance * scale_ : std::numeric_limits<double>::infinity();
  squares_ += percent * percent;
  if (percent > largest_ || farthest_.vertex < 0) {
    largest_ = percent;
    farthestClip_ = clip_;
    farthest_.time = time_;
    farthest_.vertex = vertex;
  }
  ++count_;
  ++counts_[std::bit_cast<std::uint32_t>(static_cast<float>(percent)) >> kDroppedBits];
}

ErrorFigures ErrorMeter::figures() const {
  ErrorFigures figures;
  figures.poses = poses_;
  if (count_ == 0) return figures;
  figures.rms = std::sqrt(squares_ / static_cast<double>(count_));
  figures.largest = largest_;
  figures.farthest = farthest_;
  std::uint64_t above = count_ / 1000;
  std::size_t slot = counts_.size() - 1;
  while (counts_[slot] <= above) above -= counts_[slot--];
  const auto upper = std::bit_cast<float>(static_cast<std::uint32_t>(slot + 1) << kDroppedBits);
  figures.percentile999 = std::min(static_cast<double>(upper), largest_);
  return figures;
}

}  // namespace sinew::exporting
