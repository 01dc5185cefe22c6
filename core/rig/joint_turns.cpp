// core/rig/joint_turns.cpp: angles between bones, and of turns.
#include "core/rig/joint_turns.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "core/character/pose_override.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

glm::dvec3 directionIn(const glm::mat4& boneInWorld, const Bone& bone) {
  return glm::dmat3(glm::mat3(boneInWorld)) * glm::dvec3(bone.tip);
}

/// Exact near 0 and near a half turn, where acos is not.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

float bendOf(const Skeleton& skeleton, const Pose& pose, int bone) {
  const Bone& own = at(skeleton.bones, bone);
  const glm::dvec3 inBind = directionIn(own.bindInWorld, own);
  const glm::dvec3 now = directionIn(at(pose.boneInWorld, bone), own);
  if (own.parent < 0) return static_cast<float>(glm::degrees(angleBetween(inBind, now)));
  const Bone& parent = at(skeleton.bones, own.parent);
  const double bound = angleBetween(directionIn(parent.bindInWorld, parent), inBind);
  const double bent = angleBetween(directionIn(at(pose.boneInWorld, own.parent), parent), now);
  return static_cast<float>(glm::degrees(bent - bound));
}

glm::vec3 boneDirection(const Bone& bone) {
  const glm::vec3 inFrame = glm::transpose(turnFrame(bone.bindInWorld)) * glm::mat3(bone.bindInWorld) * bone.tip;
  return normalizeOr(inFrame, glm::vec3(0.0f, 1.0f, 0.0f));
}

float turnAbout(const glm::quat& turn, const glm::vec3& axis) {
  const double along = glm::dot(glm::dvec3(turn.x, turn.y, turn.z), glm::dvec3(axis));
  const auto w = static_cast<double>(turn.w);
  // A quaternion and its negative are one turn.
  return static_cast<float>(glm::degrees(2.0 * (w < 0.0 ? std::atan2(-along, -w) : std::atan2(along, w))));
}

float nearness(const glm::quat& turn, const glm::quat& wanted, float width) {
  const glm::dquat between = glm::conjugate(glm::dquat(wanted)) * glm::dquat(turn);
  const double angle =
      glm::degrees(2.0 * std::atan2(glm::length(glm::dvec3(between.x, between.y, between.z)), std::abs(between.w)));
  const double share = angle / static_cast<double>(width);
  return static_cast<float>(std::exp(-0.5 * share * share));
}

}  // namespace sinew
