// core/files/fit/poses.cpp: sample times of clips, and their use.
#include "core/files/fit/poses.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/files/gltf/glb.h"
#include "core/geometry/at.h"
#include "sinew/character/pose_check.h"

namespace sinew::exporting {

void requireFinite(const Character& character, const Pose& pose, const Surface& surface) {
  const auto isSound = [](const glm::vec3& position) { return isFinite(position); };
  // The surface of an unsound pose is that of another pose.
  if (isSoundPose(character, pose) && std::ranges::all_of(surface.positions, isSound)) return;
  std::array<char, 32> second{};
  std::snprintf(second.data(), second.size(), "%.3f s", static_cast<double>(pose.time));
  const std::string place = pose.clip.empty() ? "bind pose" : "clip \"" + pose.clip + "\" at " + second.data();
  gltf::refuse(place, "moves or scales bones so far that places are no longer finite numbers");
}

constexpr int kFurtherPerSecond = 10;
constexpr int kHeldOutEvery = 5;  ///< One of this many poses is held out of the fit.
constexpr int kEnough = 150;      ///< Fitted poses before thinning.
constexpr int kMostStep = 3;      ///< 10 poses a second at least.

std::vector<float> clipTimes(const AnimationClip& clip, double perSecond) {
  const double frames = static_cast<double>(clip.duration) * perSecond;
  std::vector<float> times;
  for (int frame = 0; frame <= frames + kSameTime; ++frame) {
    times.push_back(static_cast<float>(frame) / static_cast<float>(perSecond));
  }
  const bool moves = times.size() == 1 && clip.duration > 0.0f;
  if (moves || frames - std::floor(frames + kSameTime) > kSameTime) times.push_back(clip.duration);
  return times;
}

std::vector<ExportPose> exportPoses(const Character& character, const std::vector<int>& clips,
                                    const std::vector<int>& further) {
  std::vector<ExportPose> poses;
  int fitted = 0;
  const auto add = [&](int clip, int perSecond, std::size_t step) {
    const std::vector<float> times = clipTimes(at(character.clips, clip), perSecond);
    for (std::size_t frame = 0; frame < times.size(); ++frame) {
      ExportPose pose{clip, times[frame], PoseUse::kMeasured};
      if (frame % step == 0) pose.use = ++fitted % kHeldOutEvery == 0 ? PoseUse::kHeldOut : PoseUse::kFitted;
      poses.push_back(pose);
    }
  };
  std::size_t all = 0;
  for (const int clip : clips) all += clipTimes(at(character.clips, clip), kMeasuredPerSecond).size();
  const std::size_t step = std::clamp<std::size_t>(all / kEnough, 1, kMostStep);
  for (const int clip : clips) add(clip, kMeasuredPerSecond, step);
  for (const int clip : further) add(clip, kFurtherPerSecond, 1);
  return poses;
}

}  // namespace sinew::exporting
