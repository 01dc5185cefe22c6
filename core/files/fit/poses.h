// core/files/fit/poses.h: the poses that an export is fitted to and measured in.
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

// Progress through the stages of one export.

/// Thrown out of an export that its caller canceled.
struct Canceled {};

class StageProgress {
 public:
  explicit StageProgress(ExportProgress tell) : tell_(std::move(tell)) {}

  /// The next stage, and what share of all the work it is.
  void begin(double share) {
    before_ += stage_;
    stage_ = share;
    tell(0.0);
  }
  /// How much of the stage is done, 0..1. Throws Canceled.
  void tell(double part) const {
    if (tell_ && !tell_(std::min(1.0, before_ + stage_ * part))) throw Canceled{};
  }

 private:
  ExportProgress tell_;
  double before_ = 0.0;
  double stage_ = 0.0;
};

// The live surface at one moment after the other, several computed at once.

/// Throws gltf::Refusal, naming clip and second, unless all bones and positions are finite: joints that scale joints
/// that scale others lead beyond what floats hold.
void requireFinite(const Character& character, const Pose& pose, const Surface& surface);

class LiveSurfaces {
 public:
  explicit LiveSurfaces(std::shared_ptr<const Character> character) : character_(character), smoother_(character) {}

  [[nodiscard]] Result<void> prepare(const Rig& rig) { return smoother_.prepare(rig); }
  /// Throws as requireFinite().
  void smooth(const Pose& pose, Surface& out) {
    smoother_.smooth(std::span(&pose, 1), std::span(&out, 1));
    requireFinite(*character_, pose, out);
  }

  /// Calls use(i, pose, surface) for i = 0..count-1, in order and from this thread. Throws as requireFinite().
  /// @param poseOf  pose of i
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
  static constexpr std::size_t kPosesOfThread = 4;  ///< Held at once.

  std::shared_ptr<const Character> character_;
  CrowdSmoother smoother_;
  std::vector<Pose> poses_;
  std::vector<Surface> surfaces_;
};

inline constexpr int kMeasuredPerSecond = 30;
inline constexpr int kFurtherPerSecond = 10;
inline constexpr double kSameTime = 1e-3;  ///< Share of a frame: times no farther apart are one.
inline constexpr int kHeldOutEvery = 5;    ///< A fifth of what could be fitted is kept from the fit.

/// What a pose is for.
enum class PoseUse { kMeasured, kFitted, kHeldOut };

struct ExportPose {
  int clip = 0;  ///< Index in the character that has them all.
  float time = 0.0f;
  PoseUse use = PoseUse::kMeasured;
};

/// Times of a clip, seconds: so many a second from its start on, then its end.
[[nodiscard]] std::vector<float> clipTimes(const AnimationClip& clip, double perSecond);

/// Clips at 30 poses a second and at their ends. All of them are fitted or held out where the clips are short; where
/// they are long, every second or third. Further clips at 10 poses a second, all fitted or held out.
/// @param clips    of the exported file: indices into character.clips
/// @param further  clips that are fitted to but not exported, likewise
[[nodiscard]] std::vector<ExportPose> exportPoses(const Character& character, const std::vector<int>& clips,
                                                  const std::vector<int>& further);

}  // namespace sinew::exporting
