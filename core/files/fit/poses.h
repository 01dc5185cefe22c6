// core/files/fit/poses.h: the poses for fitting and measuring an export, and their live surfaces.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/files/progress.h"
#include "sinew/geometry/threads.h"
#include "sinew/surface/crowd_smoother.h"

namespace sinew::exporting {

/// Thrown when the caller cancels an export.
struct Canceled {};

/// Progress through the stages of an export.
class StageProgress {
 public:
  explicit StageProgress(ExportProgress tell) : tell_(std::move(tell)) {}

  /// Begins a stage. @param share  its fraction of all work
  void begin(double share) {
    before_ += stage_;
    stage_ = share;
    tell(0.0);
  }
  /// @param part  fraction of the stage that is done, 0..1. Throws Canceled.
  void tell(double part) const {
    if (tell_ && !tell_(std::min(1.0, before_ + stage_ * part))) throw Canceled{};
  }

 private:
  ExportProgress tell_;
  double before_ = 0.0;
  double stage_ = 0.0;
};

/// Throws gltf::Refusal with clip and time unless all bones and positions are finite: nested scales can exceed floats.
void requireFinite(const Character& character, const Pose& pose, const Surface& surface);

/// Live surfaces of many poses, several computed at once.
class LiveSurfaces {
 public:
  explicit LiveSurfaces(std::shared_ptr<const Character> character) : character_(character), smoother_(character) {}

  [[nodiscard]] Result<void> prepare(const Rig& rig) { return smoother_.prepare(rig); }
  /// Throws as requireFinite().
  void smooth(const Pose& pose, Surface& out) {
    smoother_.smooth(std::span(&pose, 1), std::span(&out, 1));
    requireFinite(*character_, pose, out);
  }

  /// Calls use(i, poseOf(i), surface) for i = 0..count-1, in order, on this thread. Throws as requireFinite().
  template <class PoseOf, class Use>
  void forEach(std::size_t count, const PoseOf& poseOf, const Use& use) {
    const std::size_t many = kPosesOfThread * static_cast<std::size_t>(threadCount());
    for (std::size_t first = 0; first < count; first += many) {
      const std::size_t now = std::min(many, count - first);
      poses_.clear();
      for (std::size_t i = 0; i < now; ++i) poses_.push_back(poseOf(first + i));
      if (surfaces_.size() < now) surfaces_.resize(now);
      smoother_.smooth(poses_, std::span(surfaces_).first(now));
      for (std::size_t i = 0; i < now; ++i) {
        requireFinite(*character_, poses_[i], surfaces_[i]);
        use(first + i, poses_[i], surfaces_[i]);
      }
    }
  }

 private:
  static constexpr std::size_t kPosesOfThread = 4;  ///< In memory.

  std::shared_ptr<const Character> character_;
  CrowdSmoother smoother_;
  std::vector<Pose> poses_;
  std::vector<Surface> surfaces_;
};

inline constexpr int kMeasuredPerSecond = 30;
inline constexpr double kSameTime = 1e-3;  ///< Fraction of a frame: closer times are the same.

enum class PoseUse { kMeasured, kFitted, kHeldOut };

struct ExportPose {
  int clip = 0;  ///< Index in the character with all clips.
  float time = 0.0f;
  PoseUse use = PoseUse::kMeasured;
};

/// Sample times of a clip in seconds: `perSecond` a second from its start, then its end.
[[nodiscard]] std::vector<float> clipTimes(const AnimationClip& clip, double perSecond);

/// Poses of clips at 30 a second and at their ends. Of short clips all are fitted or held out; of long ones every
/// second or third. Further clips have 10 poses a second, all fitted or held out.
/// @param clips    exported: indices into character.clips  @param further  fitted but not exported
[[nodiscard]] std::vector<ExportPose> exportPoses(const Character& character, const std::vector<int>& clips,
                                                  const std::vector<int>& further);

}  // namespace sinew::exporting
