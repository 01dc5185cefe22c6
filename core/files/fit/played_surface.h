// core/files/fit/played_surface.h: an export as a program plays it, from the numbers that the file holds.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/files/fit/four_weights.h"
#include "core/files/fit/helper_joint.h"
#include "core/files/fit/refined_targets.h"
#include "sinew/character/character.h"
#include "sinew/files/exported_surface.h"

namespace sinew::exporting {

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
