// app/bench/measuring.h: a clock, medians and the frames to measure, for the benchmarks.
#pragma once

#include <vector>

#include "sinew/character/character.h"
#include "sinew/skeleton/pose.h"

namespace sinew::app {

/// Of a clock that never goes back; only differences mean anything.
[[nodiscard]] double secondsNow();

/// The upper one of an even number; 0 of none.
[[nodiscard]] double median(std::vector<double> values);

/// Median of above[i] / below[i], of those with below[i] > 0; 0 of none. Both of one length.
[[nodiscard]] double medianRatio(const std::vector<double>& above, const std::vector<double>& below);

/// Spread evenly over the first clip; the bind pose alone where there is none.
[[nodiscard]] std::vector<Pose> spreadFrames(const Character& character, int count);

}  // namespace sinew::app
