// core/lines/line_lengths.cpp: every clip, fifteen times a second.
#include "core/lines/line_lengths.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/lines/line_pose.h"

namespace sinew {
namespace {

constexpr float kHertz = 15.0f;

}  // namespace

LineLengths lengthsOver(const LineRest& rest, const Character& character, std::span<const AnimationClip> clips) {
  std::vector<float> stretches;
  LineLengths lengths;
  for (const AnimationClip& clip : clips) {
    const int steps = std::max(1, static_cast<int>(std::ceil(clip.duration * kHertz)));
    for (int step = 0; step <= steps; ++step) {
      const float time = clip.duration * static_cast<float>(step) / static_cast<float>(steps);
      const PosedLine line = posedLine(rest, character.skeleton, samplePose(character.skeleton, clip, time));
      if (!line.usable) continue;
      const float stretch = line.stretch;
      if (stretches.empty() || stretch < lengths.least) {
        lengths.least = stretch;
        lengths.shortestIn = clip.name;
      }
      if (stretches.empty() || stretch > lengths.most) {
        lengths.most = stretch;
        lengths.longestIn = clip.name;
      }
      stretches.push_back(stretch);
    }
  }
  lengths.poses = static_cast<int>(stretches.size());
  if (stretches.empty()) return lengths;
  const auto rank = static_cast<std::ptrdiff_t>(0.02 * static_cast<double>(stretches.size() - 1));
  std::ranges::nth_element(stretches, stretches.begin() + rank);
  lengths.secondPercentile = stretches[static_cast<std::size_t>(rank)];
  return lengths;
}

}  // namespace sinew
