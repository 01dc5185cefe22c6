// app/ui/frame_stats.h: durations of recent frames.
#pragma once

#include <deque>

#include "sinew/surface/surface.h"

namespace sinew::app {

/// Durations of the frames of the last two seconds, milliseconds.
class FrameStats {
 public:
  void add(double now, double milliseconds);  ///< @param now  seconds, monotonic

  [[nodiscard]] double now() const { return frames_.empty() ? 0.0 : frames_.back().milliseconds; }
  [[nodiscard]] double median() const;
  [[nodiscard]] double worst() const;
  [[nodiscard]] double framesPerSecond() const;  ///< From the median; 0 before the first frame.
  [[nodiscard]] int count() const { return static_cast<int>(frames_.size()); }
  [[nodiscard]] double at(int index) const { return frames_[static_cast<std::size_t>(index)].milliseconds; }

  // Stages of the last frame, seconds.
  StageSeconds stages;
  double prepare = 0.0;  ///< After an edit; 0 in frames without one.
  double upload = 0.0;
  double draw = 0.0;
  double ui = 0.0;  ///< Keys, panels and tools.

 private:
  struct Sample {
    double time = 0.0;
    double milliseconds = 0.0;
  };
  std::deque<Sample> frames_;
};

}  // namespace sinew::app
