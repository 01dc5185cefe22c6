// core/files/fit/live_surfaces.h: the live surface at one moment after the other, several computed at once.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "sinew/geometry/threads.h"
#include "sinew/surface/crowd_smoother.h"

namespace sinew::exporting {

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

}  // namespace sinew::exporting
