// core/rig/line_lengths.cpp: every clip, fifteen times a second if there are no hours of them.
#include "core/rig/line_lengths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/rig/line_pose.h"

namespace sinew {
namespace {

constexpr float kHertz = 15.0f;
constexpr double kMostPoses = 60'000.0;  ///< Of all clips together, about an hour: longer ones are sampled more thinly.

/// No integer: a file may say that a clip lasts for ages.
float stepsOf(const AnimationClip& clip, float hertz) { return std::max(1.0f, std::ceil(clip.duration * hertz)); }

float samplesPerSecond(std::span<const AnimationClip> clips) {
  double all = 0.0;
  for (const AnimationClip& clip : clips) all += static_cast<double>(stepsOf(clip, kHertz));
  return all > kMostPoses ? static_cast<float>(static_cast<double>(kHertz) * kMostPoses / all) : kHertz;
}

/// The lengths of one line, pose after pose.
struct Track {
  std::vector<float> stretches;
  LineLengths lengths;

  void add(float stretch, const std::string& clip) {
    if (stretches.empty() || stretch < lengths.least) {
      lengths.least = stretch;
      lengths.shortestIn = clip;
    }
    if (stretches.empty() || stretch > lengths.most) {
      lengths.most = stretch;
      lengths.longestIn = clip;
    }
    stretches.push_back(stretch);
  }
  LineLengths finish() {
    lengths.poses = static_cast<int>(stretches.size());
    if (stretches.empty()) return lengths;
    const auto rank = static_cast<std::ptrdiff_t>(0.02 * static_cast<double>(stretches.size() - 1));
    std::ranges::nth_element(stretches, stretches.begin() + rank);
    lengths.secondPercentile = stretches[static_cast<std::size_t>(rank)];
    return lengths;
  }
};

}  // namespace

LineLengths lengthsOver(const LineRest& rest, const Character& character, std::span<const AnimationClip> clips) {
  return lengthsOver(std::span(&rest, 1), character, clips).front();
}

std::vector<LineLengths> lengthsOver(std::span<const LineRest> rests, const Character& character,
                                     std::span<const AnimationClip> clips) {
  std::vector<Track> tracks(rests.size());
  const float hertz = samplesPerSecond(clips);
  for (const AnimationClip& clip : clips) {
    const int steps = static_cast<int>(stepsOf(clip, hertz));
    for (int step = 0; step <= steps; ++step) {
      const float time = clip.duration * static_cast<float>(step) / static_cast<float>(steps);
      const Pose pose = samplePose(character.skeleton, clip, time);
      for (std::size_t i = 0; i < rests.size(); ++i) {
        const PosedLine line = posedLine(rests[i], character.skeleton, pose);
        if (line.usable) tracks[i].add(line.stretch, clip.name);
      }
    }
  }
  std::vector<LineLengths> lengths;
  for (Track& track : tracks) lengths.push_back(track.finish());
  return lengths;
}

LineLengths lengthsOver(const LineRest& rest, const Skeleton& skeleton, std::span<const Pose> poses) {
  Track track;
  LineScratch scratch;
  std::vector<PosedLine> posed;
  const std::array<std::optional<LineRest>, 1> rests{rest};
  for (const Pose& pose : poses) {
    poseLines(rests, skeleton, pose, scratch, posed);
    if (posed[0].usable) track.add(posed[0].stretch, pose.clip);
  }
  return track.finish();
}

}  // namespace sinew
