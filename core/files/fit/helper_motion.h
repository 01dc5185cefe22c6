// core/files/fit/helper_motion.h: where rigid helpers go in one pose, their weights given.
#pragma once

#include <span>
#include <vector>

#include "core/files/fit/four_weights.h"
#include "core/files/fit/helper_joint.h"

namespace sinew::exporting {

/// A moment that weights and helpers are fitted in.
struct FitPose {
  Pose pose;
  std::vector<glm::dmat4> matrices;  ///< [bindings and lines' joints] world of the bind pose -> world now.
  std::vector<glm::vec3> live;       ///< [vertices] of the live surface.
  bool further = false;              ///< One that no exported clip holds.
};

/// Rigid helpers in one pose by block coordinate descent: one after the other takes the rigid motion nearest to where
/// its vertices would have to be, each counting by its weight squared, while the others stand still. Every step lowers
/// the same sum of squares that the weights are fitted to, so the two can go on by turns.
class HelperMotion {
 public:
  /// @param rest  [vertices]  @param weights  [vertices] bindings from `first` on are helpers, in order
  HelperMotion(const Skeleton& skeleton, std::span<const glm::vec3> rest, std::span<const FourWeights> weights,
               std::span<const HelperJoint> helpers, int first);

  /// @param matrices  of the pose, [first]
  /// @param locals  [helpers] where to begin, and where they come to; as floats hold it
  void solve(const Pose& pose, std::span<const glm::dmat4> matrices, std::span<const glm::vec3> live, int rounds,
             std::vector<Trs>& locals) const;

 private:
  void solveOne(std::size_t helper, const Pose& pose, std::span<const glm::dmat4> all, std::span<const glm::vec3> live,
                Trs& local) const;

  struct Helper {
    std::vector<int> vertices;  ///< That follow it.
    glm::dmat4 intoBone{1.0};   ///< World of the bind pose -> its bone's space.
    double spread = 0.0;        ///< Mean distance of what follows it from its place.
    double hold = 0.0;          ///< How much it is held to where it rests.
  };
  std::span<const glm::vec3> rest_;
  std::span<const FourWeights> weights_;
  std::span<const HelperJoint> joints_;
  std::vector<Helper> helpers_;
  int first_ = 0;
};

}  // namespace sinew::exporting
