// app/bench/measuring.cpp: a clock, medians and the frames to measure, for the benchmarks.
#include "app/bench/measuring.h"

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

std::vector<Pose> spreadFrames(const Character& character, int frames) {
  if (character.clips.empty()) return {bindPose(character.skeleton)};
  const AnimationClip& clip = character.clips.front();
  std::vector<Pose> poses;
  for (int i = 0; i < frames; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(frames);
    poses.push_back(samplePose(character.skeleton, clip, clip.duration * share));
  }
  return poses;
}

}  // namespace sinew::app
