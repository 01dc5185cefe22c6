// app/bench/threads.h: what a second thread gains.
#pragma once

#include "app/bench/scene.h"

namespace sinew::app {

/// Time on one thread over time on two, medians; 1 where the machine has one core.
struct ThreadGain {
  double single = 1.0;  ///< Of one surface at kBenchDepth.
  double crowd = 1.0;   ///< Of a hundred moments at depth 3, smoothed at once.
};

/// Error: the rig is refused.
[[nodiscard]] Result<ThreadGain> measureThreads(const BenchScene& scene, int rounds);

}  // namespace sinew::app
