// core/files/fit/helper_joint.cpp: how a helper joint moves what follows it.
#include "core/files/fit/helper_joint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

constexpr double kFlat = 1e-5;  ///< Determinant, beside that of a scale as large in all directions.

}  // namespace

HelperJoint makeHelper(std::string name, int bone, const Trs& rest, const Skeleton& skeleton) {
  const Trs held = roundToFloats(rest);
  const glm::dmat4 inBind = glm::dmat4(at(skeleton.bones, bone).bindInWorld) * held.toMatrix();
  return {std::move(name), bone, held, glm::dmat4(glm::mat4(glm::inverse(inBind))), -1};
}

glm::dmat4 helperMatrix(const HelperJoint& joint, const Pose& pose, const Trs& local) {
  return glm::dmat4(at(pose.boneInWorld, joint.bone)) * local.toMatrix() * joint.inverseBind;
}

std::optional<glm::dmat4> fromWorld(const Pose& pose, int bone) {
  const glm::dmat4 inWorld(at(pose.boneInWorld, bone));
  const glm::dmat3 axes(inWorld);
  const double longest = std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
  if (!(std::abs(glm::determinant(axes)) > kFlat * longest * longest * longest)) return std::nullopt;
  return glm::inverse(inWorld);
}

}  // namespace sinew::exporting
