// app/command/measuring.cpp: scenes, frames and medians for the benchmarks.
#include "app/command/measuring.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/document.h"
#include "core/rig/trial_rig.h"
#include "sinew/character/character_pose.h"

namespace sinew::app {

constexpr int kTrialMuscles = 12;
constexpr std::uint64_t kTrialSeed = 1;

Result<BenchScene> openScene(const std::filesystem::path& file) {
  const Result<Document> document = openDocument(file);
  if (!document) return document.error();
  const std::string name = file.filename().string();
  const bool bare = document->rig().primitives.empty();
  return BenchScene{name.substr(0, name.find('.', 1)), document->character,
                    bare ? trialRig(*document->character, kTrialMuscles, kTrialSeed) : document->rig()};
}

Rig rigAt(const BenchScene& scene, int depth) {
  Rig rig = scene.rig;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = depth;
  rig.smoothing.autoDepth = false;
  return rig;
}

Result<Smoother> preparedSmoother(const BenchScene& scene, const Rig& rig, ProjectionKind projection) {
  Smoother smoother(scene.character, projection);
  if (const Result<void> prepared = smoother.prepare(rig); !prepared) return prepared.error();
  return smoother;
}

namespace {

/// @param seconds  into the first clip, which loops
Pose loopedPose(const Character& character, double seconds) {
  if (character.clips.empty()) return bindPose(character.skeleton);
  const AnimationClip& clip = character.clips.front();
  const float time = clip.duration > 0.0f ? std::fmod(static_cast<float>(seconds), clip.duration) : 0.0f;
  return samplePose(character, clip, time);
}

}  // namespace

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

double exponent(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<std::pair<double, double>> logs;
  double meanX = 0.0, meanY = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > 0.0) || !(y[i] > 0.0)) continue;
    logs.emplace_back(std::log(x[i]), std::log(y[i]));
    meanX += logs.back().first;
    meanY += logs.back().second;
  }
  if (logs.empty()) return 0.0;
  meanX /= static_cast<double>(logs.size());
  meanY /= static_cast<double>(logs.size());
  double together = 0.0, alone = 0.0;
  for (const auto& [u, v] : logs) {
    together += (u - meanX) * (v - meanY);
    alone += (u - meanX) * (u - meanX);
  }
  return alone > 0.0 ? together / alone : 0.0;
}

void inTurn(std::size_t variants, int rounds, const std::function<void(std::size_t, int)>& run) {
  for (int round = 0; round <= rounds; ++round) {
    for (std::size_t i = 0; i < variants; ++i) run((i + static_cast<std::size_t>(round)) % variants, round);
  }
}

std::vector<Pose> steadyFrames(const Character& character, int count, double step) {
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) poses.push_back(loopedPose(character, step * i));
  return poses;
}

std::vector<Pose> cutFrames(const Character& character, int count) {
  const double duration = character.clips.empty() ? 0.0 : static_cast<double>(character.clips.front().duration);
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) poses.push_back(loopedPose(character, duration * (0.5 * (i % 2) + 0.4 * i / count)));
  return poses;
}

std::vector<Pose> spreadFrames(const Character& character, int frames) {
  if (character.clips.empty()) return {bindPose(character.skeleton)};
  const AnimationClip& clip = character.clips.front();
  std::vector<Pose> poses;
  for (int i = 0; i < frames; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(frames);
    poses.push_back(samplePose(character, clip, clip.duration * share));
  }
  return poses;
}

}  // namespace sinew::app
