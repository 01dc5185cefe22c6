// core/files/fit/helper_motion.h: joints that an export adds (rigid helpers, muscle lines) and their motion in a pose.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/files/fit/weight_fit.h"
#include "core/geometry/at.h"
#include "core/rig/line_rest.h"
#include "core/rig/posed_rig.h"
#include "sinew/character/pose.h"
#include "sinew/files/skinned_export.h"

namespace sinew::exporting {

/// Transform of a joint's node: p -> translation + rotation * (scale * p).
struct Trs {
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  ///< Unit.
  glm::dvec3 scale{1.0};

  [[nodiscard]] glm::dmat4 toMatrix() const;
};

/// Decomposes a matrix with orthogonal, right-handed columns. Others are orthogonalized: the second column keeps its
/// direction. A column of zeros gives scale 0.
[[nodiscard]] Trs trsOf(const glm::dmat4& matrix);

[[nodiscard]] Trs roundToFloats(const Trs& exact);  ///< Rounded to floats, with a unit rotation.

/// A joint that the export adds.
struct HelperJoint {
  std::string name;
  int bone = 0;                 ///< Its parent.
  Trs rest;                     ///< In the parent's space; also in clips without keys for the joint.
  glm::dmat4 inverseBind{1.0};  ///< World of the bind pose -> the joint's space at rest.
  int line = -1;                ///< The rig's line that it follows; -1: a rigid helper.
};

struct HelperClip {
  std::string clip;
  std::vector<float> times;              ///< [keys] seconds, rising.
  std::vector<std::vector<Trs>> locals;  ///< [joints][keys] in their parents' spaces.
};

/// A child of a bone. @param rest  in the bone's space in the bind pose
[[nodiscard]] HelperJoint makeHelper(std::string name, int bone, const Trs& rest, const Skeleton& skeleton);

/// World of the bind pose -> world now. @param local  in its parent's space
[[nodiscard]] glm::dmat4 helperMatrix(const HelperJoint& joint, const Pose& pose, const Trs& local);

/// World -> bone in a pose; nullopt where the pose flattens the bone, so that keys of a joint below it cannot move
/// anything in some direction.
[[nodiscard]] std::optional<glm::dmat4> fromWorld(const Pose& pose, int bone);

/// The rigid motion that brings points nearest to others (Horn 1987, closed form with quaternions).
class RigidMotion {
 public:
  void add(const glm::dvec3& from, const glm::dvec3& to, double weight);
  [[nodiscard]] double weight() const { return weight_; }

  struct Motion {
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  ///< Unit; p -> rotation * p + translation.
    glm::dvec3 translation{0.0};
  };
  [[nodiscard]] Motion best() const;  ///< Minimizes the sum of weight * |motion(from) - to|^2. Identity without points.

 private:
  double weight_ = 0.0;
  glm::dvec3 from_{0.0};
  glm::dvec3 to_{0.0};
  glm::dmat3 products_{0.0};  // Column i: sum of from[i] * to.
};

struct FitPose {
  Pose pose;
  std::vector<glm::dmat4> matrices;  ///< [bindings and lines' joints] world of the bind pose -> world now.
  std::vector<glm::vec3> live;       ///< [vertices] of the live surface.
  bool further = false;              ///< Not of an exported clip.
};

/// Solves rigid helpers in one pose by block coordinate descent: each in turn takes the rigid motion that best moves
/// its vertices where they should be, weighted by their squared weights, while the others stand still. Every step
/// lowers the sum of squares that weights are fitted to, so that fits of weights and motions can alternate.
class HelperMotion {
 public:
  /// @param rest  [vertices]  @param weights  [vertices]  @param first  binding of the first helper
  HelperMotion(const Skeleton& skeleton, std::span<const glm::vec3> rest, std::span<const FourWeights> weights,
               std::span<const HelperJoint> helpers, int first);

  /// @param matrices  [first] of the pose  @param locals  [helpers] initial and result, rounded to floats
  void solve(const Pose& pose, std::span<const glm::dmat4> matrices, std::span<const glm::vec3> live, int rounds,
             std::vector<Trs>& locals) const;

 private:
  void solveOne(std::size_t helper, const Pose& pose, std::span<const glm::dmat4> all, std::span<const glm::vec3> live,
                Trs& local) const;

  struct Helper {
    std::vector<int> vertices;  ///< With a weight for it.
    glm::dmat4 intoBone{1.0};   ///< World of the bind pose -> its bone's space.
    double spread = 0.0;        ///< Mean distance of its vertices.
    double hold = 0.0;          ///< Weight of its rest position.
  };
  std::span<const glm::vec3> rest_;
  std::span<const FourWeights> weights_;
  std::span<const HelperJoint> joints_;
  std::vector<Helper> helpers_;
  int first_ = 0;
};

/// Joints for the lines with muscles, in the rig's order: one each, or two where joints may not scale. A line deforms
/// by a rotation, a translation and a scale along its own axes (docs/muscles.md), so that a joint can follow it.
class LineJoints {
 public:
  LineJoints() = default;
  /// @param poses  where joints must be exact: the parent is the nearest bone, from that of the line's origin upwards,
  ///               that they never scale unevenly
  LineJoints(const Rig& rig, const Character& character, JointScale scale, std::span<const Pose> poses);

  [[nodiscard]] const std::vector<HelperJoint>& joints() const { return joints_; }
  [[nodiscard]] JointScale scale() const { return scale_; }
  /// The bind pose of a joint's line, with the rig's own settings. @param line  HelperJoint::line
  [[nodiscard]] const LineRest& restOf(int line) const { return *at(rests_, line); }
  [[nodiscard]] const std::string& nameOf(int line) const { return at(names_, line); }
  void pose(const Pose& pose, std::vector<Trs>& locals) const;  ///< [joints] in their parents' spaces.
  void keep(const std::vector<bool>& kept);                     ///< Removes joints. @param kept  [joints]

 private:
  void add(int line, std::string name, int bone, const glm::dvec3& place);

  const Character* character_ = nullptr;
  std::optional<RigPoser> poser_;
  JointScale scale_ = JointScale::kFull;
  std::vector<std::string> names_;  ///< [lines]
  std::vector<std::optional<LineRest>> rests_;
  std::vector<glm::dmat4> fromBind_;  ///< [lines] world of the exported bind pose -> of the pose before deformation.
  std::vector<HelperJoint> joints_;
};

}  // namespace sinew::exporting
