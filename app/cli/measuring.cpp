// app/cli/measuring.cpp: a clock and medians, for the benchmarks.
#include "app/cli/measuring.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace sinew::app {

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

double medianRatio(const std::vector<double>& above, const std::vector<double>& below) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < above.size(); ++i) {
    if (below[i] > 0.0) ratios.push_back(above[i] / below[i]);
  }
  return median(std::move(ratios));
}

}  // namespace sinew::app
