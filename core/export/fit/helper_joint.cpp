// core/export/fit/helper_joint.cpp: how a helper joint moves what follows it.
#include "core/export/fit/helper_joint.h"

#include <utility>

#include <glm/matrix.hpp>

#include "core/base/at.h"

namespace sinew::exporting {

HelperJoint makeHelper(std::string name, int bone, const Trs& rest, const Skeleton& skeleton) {
  const Trs held = rounded(rest);
  const glm::dmat4 inBind = glm::dmat4(at(skeleton.bones, bone).bindInWorld) * held.toMatrix();
  return {std::move(name), bone, held, glm::dmat4(glm::mat4(glm::inverse(inBind))), -1};
}

glm::dmat4 helperMatrix(const HelperJoint& joint, const Pose& pose, const Trs& local) {
  return glm::dmat4(at(pose.boneInWorld, joint.bone)) * local.toMatrix() * joint.inverseBind;
}

}  // namespace sinew::exporting
