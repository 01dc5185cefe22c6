// core/files/fit/error_meter.cpp: distances by the leading bits of their floats.
#include "core/files/fit/error_meter.h"

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
  const std::uint32_t slot = std::bit_cast<std::uint32_t>(static_cast<float>(percent)) >> kDroppedBits;
  std::vector<std::uint64_t>& octave = counts_[slot / kClassesOfOctave];
  if (octave.empty()) octave.resize(kClassesOfOctave, 0);
  ++octave[slot % kClassesOfOctave];
}

float ErrorMeter::upperBoundOfAllBut(std::uint64_t above) const {
  for (std::size_t octave = kOctaves; octave-- > 0;) {
    const std::vector<std::uint64_t>& counts = counts_[octave];
    for (std::size_t place = counts.size(); place-- > 0; above -= counts[place]) {
      if (counts[place] <= above) continue;
      const std::size_t slot = octave * kClassesOfOctave + place;
      return std::bit_cast<float>(static_cast<std::uint32_t>(slot + 1) << kDroppedBits);
    }
  }
  return 0.0f;
}

ErrorFigures ErrorMeter::figures() const {
  ErrorFigures figures;
  figures.poses = poses_;
  if (count_ == 0) return figures;
  figures.rms = std::sqrt(squares_ / static_cast<double>(count_));
  figures.largest = largest_;
  figures.farthest = farthest_;
  const float upper = upperBoundOfAllBut(count_ / 1000);
  figures.percentile999 = std::min(static_cast<double>(upper), largest_);
  return figures;
}

}  // namespace sinew::exporting
