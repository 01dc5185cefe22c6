// core/files/fit/played_surface.h: an export as a program plays it, and its error.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/files/fit/helper_motion.h"
#include "core/files/fit/poses.h"
#include "core/files/fit/weight_fit.h"
#include "sinew/character/character.h"
#include "sinew/files/exported_surface.h"
#include "sinew/files/skinned_export.h"
#include "sinew/rig/rig.h"

namespace sinew::exporting {

/// Change of the refined surface by one morph target at weight 1, in the bind pose. Sparse.
struct RefinedTarget {
  std::vector<int> vertices;       ///< Refined, ascending.
  std::vector<glm::vec3> deltas;   ///< [vertices] world.
  std::vector<int> drawn;          ///< Drawn vertices, ascending.
  std::vector<glm::vec3> normals;  ///< [drawn] change of their shading normals.
};

/// Weights of all targets over one clip, linear between keys.
struct MorphKeys {
  std::string clip;
  std::vector<float> times;    ///< [keys] seconds, rising.
  std::vector<float> weights;  ///< [keys][targets]
};

/// Morph targets as a file holds them and a program plays them.
struct PlayedMorphs {
  std::vector<RefinedTarget> targets;  ///< [Character::morphTargets]
  std::vector<float> rest;             ///< [targets] weights without a clip, including the rig's.
  std::vector<bool> keyed;             ///< [targets] the rig changes weights of the node: new keys replace the file's.
  std::vector<MorphKeys> clips;        ///< Exported clips.
};

[[nodiscard]] Pose withoutMorphs(const Character& character, Pose pose);  ///< The pose with all weights 0.

/// The surface with each target at 1, minus `bind`.
/// @param surfaces  prepared with a rig without weights  @param bind  their surface without targets
[[nodiscard]] std::vector<RefinedTarget> refinedTargets(const Character& character, LiveSurfaces& surfaces,
                                                        const Surface& bind);
/// The targets of the file's own vertices.
[[nodiscard]] std::vector<RefinedTarget> originalTargets(const Character& character);

/// Fills everything except the targets. @param poses  of exported clips, clip by clip
void setMorphKeys(const Character& character, const Rig& rig, std::span<const ExportPose> poses, PlayedMorphs& out);

/// Root mean square, 99.9 percentile and maximum of many distances, in little memory: distances are counted in classes
/// of 1/1024 of an octave, with memory only for octaves in use. Their order affects only the last bits of the sum.
class ErrorMeter {
 public:
  explicit ErrorMeter(double height) : scale_(100.0 / height) {}  ///< @param height  H: figures are in percent of it

  void add(double distance, int vertex);
  /// Begins a pose: its distances follow.
  void addPose(int clip, float time) {
    ++poses_;
    clip_ = clip;
    time_ = time;
  }
  /// A pose with its distances. @param distances  [vertices]
  void addPose(int clip, float time, std::span<const double> distances) {
    addPose(clip, time);
    for (std::size_t v = 0; v < distances.size(); ++v) add(distances[v], static_cast<int>(v));
  }
  /// Index of the clip of the largest distance; -1: none.
  [[nodiscard]] int farthestClip() const { return farthestClip_; }
  [[nodiscard]] ErrorFigures figures() const;  ///< Without names of clip and bone.

 private:
  static constexpr std::size_t kOctaves = 256;  ///< A float's exponents.
  static constexpr std::size_t kClassesOfOctave = 1024;

  /// Upper bound of all distances except the `above` largest.
  [[nodiscard]] float upperBoundOfAllBut(std::uint64_t above) const;

  double scale_ = 1.0;
  double squares_ = 0.0;
  double largest_ = 0.0;
  std::uint64_t count_ = 0;
  int poses_ = 0;
  int clip_ = -1;  ///< Of the current pose.
  float time_ = 0.0f;
  int farthestClip_ = -1;
  ErrorPlace farthest_;
  std::array<std::vector<std::uint64_t>, kOctaves> counts_;  ///< Empty, or [kClassesOfOctave].
};

/// Morph targets of one clip, added before skinning.
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

  /// Name of the bone with the largest weight; for an added joint, its parent.
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

/// Times between keys: 47 a second for 30 keys, so that they cover all phases between two keys.
[[nodiscard]] std::vector<float> timesBetween(const AnimationClip& clip, double keysPerSecond);

}  // namespace sinew::exporting
