// core/files/fit/helper_joint.h: a joint that the export adds to the character's own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/files/fit/trs.h"
#include "sinew/character/pose.h"

namespace sinew::exporting {

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

}  // namespace sinew::exporting
