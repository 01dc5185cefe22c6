// core/files/fit/error_meter.h: root mean square, 99.9 percentile and maximum of many distances, in little memory.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sinew/files/skinned_export.h"

namespace sinew::exporting {

/// Distances are counted in classes 1/1024 of an octave wide, in memory for those octaves alone that have some: there
/// is a meter for every clip. The order in which distances come does not matter but to the last bits of the sum.
class ErrorMeter {
 public:
  /// @param height  H: distances are given in percent of it
  explicit ErrorMeter(double height) : scale_(100.0 / height) {}

  /// @param vertex  whose distance it is
  void add(double distance, int vertex);
  /// The distances that follow are of this pose.
  void addPose(int clip, float time) {
    ++poses_;
    clip_ = clip;
    time_ = time;
  }
  /// Index of the clip of the largest distance; -1: none.
  [[nodiscard]] int farthestClip() const { return farthestClip_; }
  /// `farthest` without the names of clip and bone.
  [[nodiscard]] ErrorFigures figures() const;

 private:
  static constexpr std::size_t kOctaves = 256;  ///< A float's exponents.
  static constexpr std::size_t kClassesOfOctave = 1024;

  /// The float above all but `above` of the distances. There are more.
  [[nodiscard]] float upperBoundOfAllBut(std::uint64_t above) const;

  double scale_ = 1.0;
  double squares_ = 0.0;
  double largest_ = 0.0;
  std::uint64_t count_ = 0;
  int poses_ = 0;
  int clip_ = -1;  ///< Of the pose at hand.
  float time_ = 0.0f;
  int farthestClip_ = -1;
  ErrorPlace farthest_;
  std::array<std::vector<std::uint64_t>, kOctaves> counts_;  ///< Empty, or [kClassesOfOctave].
};

}  // namespace sinew::exporting
