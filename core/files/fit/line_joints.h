// core/files/fit/line_joints.h: muscle lines as joints. A line's deformation is a rotation, a translation and a
// scale along its own axes (docs/muscles.md), so a joint can do what the line does.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/files/fit/helper_motion.h"
#include "core/geometry/at.h"
#include "core/rig/line_rest.h"
#include "core/rig/posed_rig.h"
#include "sinew/files/skinned_export.h"

namespace sinew::exporting {

/// The lines that carry muscles, in the rig's order: one joint each, two where joints may not scale.
class LineJoints {
 public:
  LineJoints() = default;
  /// @param poses  in which a line's joint is to be exact: it hangs on the nearest bone, from that of the line's origin
  ///               up, that is never scaled unevenly in them
  LineJoints(const Rig& rig, const Character& character, JointScale scale, std::span<const Pose> poses);

  [[nodiscard]] const std::vector<HelperJoint>& joints() const { return joints_; }
  [[nodiscard]] JointScale scale() const { return scale_; }
  /// The bind pose of a joint's line, with the rig's own settings. @param line  HelperJoint::line
  [[nodiscard]] const LineRest& restOf(int line) const { return *at(rests_, line); }
  [[nodiscard]] const std::string& nameOf(int line) const { return at(names_, line); }
  /// [joints] in their parents' spaces.
  void pose(const Pose& pose, std::vector<Trs>& locals) const;
  /// Leaves joints out. @param kept  [joints]
  void keep(const std::vector<bool>& kept);

 private:
  void add(int line, std::string name, int bone, const glm::dvec3& place);

  const Character* character_ = nullptr;
  std::optional<RigPoser> poser_;
  JointScale scale_ = JointScale::kFull;
  std::vector<std::string> names_;  ///< [lines]
  std::vector<std::optional<LineRest>> rests_;
  std::vector<glm::dmat4> fromBind_;  ///< [lines] world of the exported bind pose -> of the pose that lines deform.
  std::vector<HelperJoint> joints_;
};

}  // namespace sinew::exporting
