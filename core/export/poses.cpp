// core/export/poses.cpp: times of clips, and which of them are kept from the fit.
#include "core/export/poses.h"

#include <cmath>

#include "core/base/at.h"

namespace sinew::exporting {
namespace {

/// Frames of a clip from its start on, its end rounded down but for what is less than a thousandth of a frame.
int framesOf(const AnimationClip& clip) {
  return static_cast<int>(std::floor(static_cast<double>(clip.duration) * kMeasuredPerSecond + 1e-3)) + 1;
}

}  // namespace

std::vector<ExportPose> exportPoses(const Character& character, const std::vector<int>& clips,
                                    const std::vector<int>& further) {
  std::vector<ExportPose> poses;
  int fitted = 0;
  const auto add = [&](int clip, int frame) {
    ExportPose pose{clip, static_cast<float>(frame) / static_cast<float>(kMeasuredPerSecond), PoseUse::kMeasured};
    if (frame % kFittedEvery == 0) {
      pose.use = ++fitted % kHeldOutEvery == 0 ? PoseUse::kHeldOut : PoseUse::kFitted;
    }
    poses.push_back(pose);
  };
  for (const int clip : clips) {
    for (int frame = 0; frame < framesOf(at(character.clips, clip)); ++frame) add(clip, frame);
  }
  for (const int clip : further) {
    for (int frame = 0; frame < framesOf(at(character.clips, clip)); frame += kFittedEvery) add(clip, frame);
  }
  return poses;
}

}  // namespace sinew::exporting
