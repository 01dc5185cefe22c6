// app/command/speedup.h: what vectors and a second thread gain, and how far vectors agree with the scalar reference.
#pragma once

#include <string>
#include <vector>

#include "app/command/scene.h"

namespace sinew::app {

/// Scalar reference over optimized, medians of frames of the same moment in the same round.
struct SetSpeedup {
  double cold = 0.0;      ///< The first frame of a smoother that has just been prepared.
  double warm60Hz = 0.0;  ///< A clip that plays at 60 frames a second ...
  double warm20Hz = 0.0;  ///< ... at 20.
  double cut = 0.0;       ///< Each moment far from the one before.
};

/// One instruction set.
struct SpeedupRow {
  std::string set;
  SetSpeedup frame;       ///< Whole frames.
  SetSpeedup projection;  ///< The projection alone.
};

/// The widest set beside the scalar reference. Shares are of the vertices a root was sought for.
struct Agreement {
  double within = 1.0;            ///< Share within 1e-4 H of the reference's.
  double uncertifiedShare = 0.0;  ///< Share that the vector path left to the scalar one.
  long long notFinite = 0;        ///< Positions and normals with a component that is no number, or infinite.
  long long projected = 0;        ///< Vertices counted.
};

struct Speedups {
  std::vector<SpeedupRow> rows;
  Agreement agreement;
};

/// At kBenchDepth, by newton. Every set and the reference have smoothers of their own, and smooth the same moments in
/// turn. The reference is so in the projection alone: the rest of its frame has the machine's vectors.
/// Error: the rig is refused.
[[nodiscard]] Result<Speedups> measureSpeedups(const BenchScene& scene, int rounds);

/// Time on one thread over time on two, medians; 1 where the machine has one core.
struct ThreadGain {
  double single = 1.0;  ///< One surface at kBenchDepth.
  double crowd = 1.0;   ///< A hundred moments at depth 3, smoothed at once.
};

/// Error: the rig is refused.
[[nodiscard]] Result<ThreadGain> measureThreads(const BenchScene& scene, int rounds);

}  // namespace sinew::app
