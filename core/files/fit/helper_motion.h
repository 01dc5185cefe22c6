// core/files/fit/helper_motion.h: where rigid helpers go in one pose, their weights given.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/files/fit/four_weights.h"
#include "core/files/fit/trs.h"
#include "sinew/character/pose.h"

namespace sinew::exporting {

// A joint that the export adds to the character's own.

struct HelperJoint {
  std::string name;
  int bone = 0;                 ///< Its parent.
  Trs rest;                     ///< In the parent's space. A clip that does not know the joint leaves it there.
  glm::dmat4 inverseBind{1.0};  ///< World of the bind pose -> the joint's space at rest.
  int line = -1;                ///< The rig's line whose belly it carries; -1: a rigid helper.
};

/// How helper joints move in a clip.
struct HelperClip {
  std::string clip;
  std::vector<float> times;              ///< [keys] seconds, rising.
  std::vector<std::vector<Trs>> locals;  ///< [joints][keys] in their parents' spaces.
};

/// Hung on a bone as it stands in the bind pose.
[[nodiscard]] HelperJoint makeHelper(std::string name, int bone, const Trs& rest, const Skeleton& skeleton);

/// World of the bind pose -> world now. @param local  in its parent's space
[[nodiscard]] glm::dmat4 helperMatrix(const HelperJoint& joint, const Pose& pose, const Trs& local);

/// World -> bone in a pose; none where the pose flattens the bone, so that no key of a joint below it moves anything
/// along some direction.
[[nodiscard]] std::optional<glm::dmat4> fromWorld(const Pose& pose, int bone);

// The rotation and translation that bring points nearest to others.

/// Sums over pairs of points, from which the best rigid motion follows (Horn 1987, closed form with quaternions).
class RigidMotion {
 public:
  void add(const glm::dvec3& from, const glm::dvec3& to, double weight);
  [[nodiscard]] double weight() const { return weight_; }

  struct Motion {
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  ///< Unit; p -> rotation * p + translation.
    glm::dvec3 translation{0.0};
  };
  /// The least sum of weight * |motion(from) - to|^2. Identity where nothing was added.
  [[nodiscard]] Motion best() const;

 private:
  double weight_ = 0.0;
  glm::dvec3 from_{0.0};
  glm::dvec3 to_{0.0};
  glm::dmat3 products_{0.0};  // Column i: sum of from[i] * to.
};

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
