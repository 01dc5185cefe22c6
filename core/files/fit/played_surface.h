// core/files/fit/played_surface.h: an export as a program plays it, from the numbers that the file holds.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/files/fit/four_weights.h"
#include "core/files/fit/helper_motion.h"
#include "core/files/fit/refined_targets.h"
#include "sinew/character/character.h"
#include "sinew/files/exported_surface.h"
#include "sinew/files/skinned_export.h"

namespace sinew::exporting {

// Root mean square, 99.9 percentile and maximum of many distances, in little memory.

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

/// Morph targets of one clip, added before joints move a vertex.
struct PlayedTargets {
  std::string clip;
  std::vector<float> times;                    ///< [keys] seconds, rising.
  std::vector<float> weights;                  ///< [keys * targets]
  std::vector<std::vector<glm::vec3>> deltas;  ///< [targets][vertices] world of the bind pose.
};

class PlayedSurface : public ExportedSurface {
 public:
  PlayedSurface(std::shared_ptr<const Character> character, std::vector<glm::vec3> restPositions,
                std::vector<FourWeights> weights, std::vector<HelperJoint> joints, std::vector<HelperClip> clips);

  void place(const Pose& pose, const std::string& clip, float time, std::vector<glm::vec3>& out) const override;

  /// Name of the bone that the vertex follows most; of a joint that was added, the bone it hangs on.
  [[nodiscard]] const std::string& boneOf(int vertex) const;

  PlayedTargets targets;
  PlayedMorphs morphs;

 private:
  [[nodiscard]] std::vector<float> morphWeightsAt(const Pose& pose, const std::string& clip, float time) const;
  [[nodiscard]] std::vector<glm::vec3> morphedRest(const Pose& pose, const std::string& clip, float time) const;
  [[nodiscard]] std::vector<glm::dmat4> matricesAt(const Pose& pose, const std::string& clip, float time) const;

  std::shared_ptr<const Character> character_;
  std::vector<FourWeights> weights_;
  std::vector<HelperJoint> joints_;
  std::vector<HelperClip> clips_;
};

/// Moments beside those that have keys: 47 a second where keys are 30, so that they fall into every part of the time
/// between two keys.
[[nodiscard]] std::vector<float> timesBetween(const AnimationClip& clip, double keysPerSecond);

}  // namespace sinew::exporting
