// app/cli/measuring.h: a clock and medians, for the benchmarks.
#pragma once

#include <vector>

namespace sinew::app {

/// Of a clock that never goes back; only differences mean anything.
[[nodiscard]] double secondsNow();

/// The upper one of an even number; 0 of none.
[[nodiscard]] double median(std::vector<double> values);

/// Median of above[i] / below[i], of those with below[i] > 0; 0 of none. Both of one length.
[[nodiscard]] double medianRatio(const std::vector<double>& above, const std::vector<double>& below);

}  // namespace sinew::app
