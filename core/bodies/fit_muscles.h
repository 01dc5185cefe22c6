// core/bodies/fit_muscles.h: the muscles that a fit may change, as unknown numbers; twins are one unknown.
#pragma once

#include <span>
#include <vector>

#include "core/bodies/fit_equations.h"
#include "core/bodies/height_model.h"
#include "core/geometry/at.h"
#include "core/rig/mirror.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// One unknown: a muscle, with its twin.
struct FitMuscle {
  int leader = 0;             ///< Index into Rig::primitives.
  int follower = -1;          ///< Its twin, kept its mirror image; or -1.
  bool staysInPlane = false;  ///< Its own mirror image.
  glm::vec3 turns{1.0f};      ///< The leader's rotation about its axes -> the follower's about its own.
  glm::dmat3 carrier{1.0};    ///< Bone space -> world.
  double scale = 1.0;         ///< World length of a length of the bone's space.
  Placement start;
  float startAmount = 1.0f;
  float hold = 1.0f;  ///< Factor on the pull back to the start.
};

/// Muscles stay near where they were: a center within 8 % of H, axes within 60 degrees, radii within a factor of 3. Not
/// changed are muscles with keys or drivers, without a bone, or with amount 0.
class FitMuscles {
 public:
  /// @param plan  null: each muscle on its own. Must outlive the use.
  FitMuscles(const Rig& rig, const Character& character, const MirrorPlan* plan);

  [[nodiscard]] std::size_t size() const { return muscles_.size(); }
  [[nodiscard]] bool empty() const { return muscles_.empty(); }
  [[nodiscard]] std::span<FitMuscle> all() { return muscles_; }
  [[nodiscard]] std::span<const FitMuscle> all() const { return muscles_; }
  [[nodiscard]] int unknownOf(int primitive) const { return at(unknownOf_, primitive); }  ///< -1: it is not changed.

  /// The changes by muscles as changes by unknowns.
  [[nodiscard]] ResidualRow rowOf(std::span<const HeightChange> changes) const;
  /// [size * kFitNumbers] how far the muscles have moved, in units of kDriftUnits, times their hold.
  [[nodiscard]] std::vector<double> drift(const Rig& rig) const;
  /// [size * kFitNumbers] d drift / d number.
  [[nodiscard]] std::vector<double> driftRates() const;
  /// The rig after a step, within the limits. @param step [size * kFitNumbers]
  [[nodiscard]] Rig moved(Rig rig, std::span<const double> step) const;
  /// One muscle as it was at the start.
  void restore(Rig& rig, std::size_t unknown) const;

 private:
  void follow(Rig& rig, const FitMuscle& muscle) const;

  const MirrorPlan* plan_;
  double height_;
  glm::dmat3 reflection_{1.0};
  std::vector<FitMuscle> muscles_;
  std::vector<int> unknownOf_;    ///< [primitives]
  std::vector<bool> isFollower_;  ///< [primitives]
};

}  // namespace sinew
