// core/bodies/motions.cpp: clips sampled; single vertices skinned.
#include "core/bodies/motions.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/rig/line_fitting.h"
#include "core/rig/motion_clip.h"

namespace sinew {

// All lines over one pass of the clips.

Rig withLearnedLengths(Rig rig, std::size_t first, const Character& character) {
  std::vector<LineRest> rests;
  std::vector<int> lines;
  for (std::size_t i = first; i < rig.lines.size(); ++i) {
    auto rest = lineRest(rig.lines[i], character);
    if (!rest) continue;
    rests.push_back(std::move(rest).value());
    lines.push_back(static_cast<int>(i));
  }
  std::vector<LineLengths> lengths = lengthsOver(rests, character, character.clips);
  const std::vector<LineLengths> own = lengths;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int twin = findLine(rig, at(rig.lines, lines[i]).mirror);
    const auto other = std::ranges::find(lines, twin);
    if (twin < 0 || other == lines.end()) continue;
    const LineLengths& theirs = own[static_cast<std::size_t>(other - lines.begin())];
    lengths[i].least = std::min(lengths[i].least, theirs.least);
    lengths[i].secondPercentile = std::min(lengths[i].secondPercentile, theirs.secondPercentile);
    lengths[i].most = std::max(lengths[i].most, theirs.most);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // An error: it never shortens.
    if (auto learned = withLearned(rig, lines[i], lengths[i])) rig = std::move(learned).value().rig;
  }
  return rig;
}

namespace {

constexpr float kHertz = 15.0f;
constexpr int kMostPoses = 6'000;  ///< Of all clips together: longer ones are sampled more thinly.

/// No integer: a file may say that a clip lasts for ages.
float stepsOf(const AnimationClip& clip, float hertz) { return std::max(1.0f, std::ceil(clip.duration * hertz)); }

}  // namespace

Motions::Motions(std::shared_ptr<const Character> given)
    : character_(withRangeOfMotion(std::move(given))), skin_(character_->mesh) {
  const Character& character = *character_;
  double all = 0.0;
  for (const AnimationClip& clip : character.clips) all += static_cast<double>(stepsOf(clip, kHertz));
  const float hertz = all > kMostPoses ? static_cast<float>(kHertz * kMostPoses / all) : kHertz;
  struct When {
    const AnimationClip* clip;
    float time;
  };
  std::vector<When> times;
  for (const AnimationClip& clip : character.clips) {
    const int steps = static_cast<int>(stepsOf(clip, hertz));
    for (int step = 0; step <= steps; ++step) {
      times.push_back({&clip, clip.duration * static_cast<float>(step) / static_cast<float>(steps)});
    }
  }
  poses_.resize(times.size());
  forEachIndex(times.size(), 16,
               [&](std::size_t i) { poses_[i] = samplePose(character.skeleton, *times[i].clip, times[i].time); });
}

std::vector<std::optional<SkinFrame>> Motions::framesOf(std::span<const SkinSpot> spots) const {
  std::vector<std::optional<SkinFrame>> out(poses_.size() * spots.size());
  forEachIndex(poses_.size(), 32, [&](std::size_t i) {
    for (std::size_t s = 0; s < spots.size(); ++s) {
      out[i * spots.size() + s] = frameAt(*character_, spots[s], poses_[i]);
    }
  });
  return out;
}

std::vector<glm::vec3> Motions::placesOf(int vertex) const {
  std::vector<glm::vec3> out;
  for (const Pose& pose : poses_) out.push_back(skinnedVertex(*character_, vertex, pose));
  return out;
}

// Lengths over poses that are already there.

void learnFull(MuscleLine& line, const Motions& motions) {
  const auto rest = lineRest(line, motions.character());
  if (!rest) return;
  const LineLengths lengths = lengthsOver(rest.value(), motions.character().skeleton, motions.poses());
  if (lengths.poses > 0 && lengths.secondPercentile < kMostFull) {
    line.settings.full = std::max(lengths.secondPercentile, kLeastFull);
  }
}

}  // namespace sinew
