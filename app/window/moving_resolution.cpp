// app/window/moving_resolution.cpp: steps of resolution, with hysteresis.

#include "app/window/moving_resolution.h"

#include <algorithm>

namespace sinew::app {
namespace {

constexpr double kTolerance = 1.1;  ///< Times the goal that are let pass.

double areaRatio(float to, float from) {
  const double ratio = static_cast<double>(to) / static_cast<double>(from);
  return ratio * ratio;
}

}  // namespace

double MovingResolution::room(double other) { return std::max(kFrameGoal - other, 0.5 * kFrameGoal); }

void MovingResolution::change(std::size_t step) {
  step_ = step;
  slow_ = fast_ = 0;
}

void MovingResolution::add(const FrameCost& cost) {
  const double room = MovingResolution::room(cost.other);
  const bool slow = cost.drawing > kTolerance * room;
  least_ = slow_ == 0 ? cost.drawing : std::min(least_, cost.drawing);
  slow_ = slow ? slow_ + 1 : 0;
  // At worst all of the drawing grows with the number of pixels, and it has filled what was hidden.
  const bool fast =
      step_ > 0 && (cost.drawing + cost.hidden) * areaRatio(kScales[step_ - 1], kScales[step_]) <= room + cost.hidden;
  fast_ = fast ? fast_ + 1 : 0;
  if (slow_ >= kFewFrames && step_ + 1 < kScales.size()) {
    // Far beyond the goal: two steps at once. A single slow frame, of many that are given time, does not count.
    const bool far = least_ * areaRatio(kScales[step_ + 1], kScales[step_]) > kTolerance * room;
    change(std::min(step_ + (far ? 2 : 1), kScales.size() - 1));
  } else if (fast_ >= kManyFrames) {
    change(step_ - 1);
  }
}

}  // namespace sinew::app
