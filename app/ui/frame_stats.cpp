// app/ui/frame_stats.cpp: durations of recent frames.
#include "app/ui/frame_stats.h"

#include <algorithm>
#include <vector>

namespace sinew::app {

void FrameStats::add(double now, double milliseconds) {
  frames_.push_back({now, milliseconds});
  while (frames_.size() > 1 && now - frames_.front().time > 2.0) frames_.pop_front();
}

double FrameStats::median() const {
  if (frames_.empty()) return 0.0;
  std::vector<double> sorted;
  sorted.reserve(frames_.size());
  for (const Sample& frame : frames_) sorted.push_back(frame.milliseconds);
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::ranges::nth_element(sorted, middle);
  return *middle;
}

double FrameStats::worst() const {
  double worst = 0.0;
  for (const Sample& frame : frames_) worst = std::max(worst, frame.milliseconds);
  return worst;
}

double FrameStats::framesPerSecond() const {
  const double typical = median();
  return typical > 0.0 ? 1000.0 / typical : 0.0;
}

}  // namespace sinew::app
