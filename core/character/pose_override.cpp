// core/character/pose_override.cpp: orthonormal frames of bones, and rotations about them.
#include "core/character/pose_override.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/at.h"

namespace sinew {
namespace {

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& fallback) {
  const double length = glm::length(v);
  return length > 0.0 && std::isfinite(length) ? v / length : fallback;
}

glm::dvec3 acrossOf(const glm::dvec3& unit) {
  const glm::dvec3 other = std::abs(unit.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  return glm::normalize(glm::cross(unit, other));
}

glm::dmat3 frameOf(const glm::dmat4& boneInWorld) {
  const glm::dmat3 bone(boneInWorld);
  const glm::dvec3 x = unitOr(bone[0], {1.0, 0.0, 0.0});
  glm::dvec3 second = bone[1] - glm::dot(bone[1], x) * x;
  // The remainder of a flattened axis is only rounding.
  if (!(glm::length(second) > 1e-6 * glm::length(bone[1]))) second = acrossOf(x);
  const glm::dvec3 y = unitOr(second, acrossOf(x));
  const glm::dvec3 z = glm::cross(x, y);
  return {x, y, glm::determinant(bone) < 0.0 ? -z : z};
}

/// The orientation of a bone with its bind rotation under its posed parent.
glm::dmat3 boundFrame(const Skeleton& skeleton, const Bone& bone, const Pose& pose) {
  const glm::dmat3 bound = frameOf(glm::dmat4(bone.bindInWorld));
  if (bone.parent < 0) return bound;
  const auto parent = static_cast<std::size_t>(bone.parent);
  const glm::dmat3 parentBound = frameOf(glm::dmat4(skeleton.bones[parent].bindInWorld));
  return frameOf(glm::dmat4(pose.boneInWorld[parent])) * glm::transpose(parentBound) * bound;
}

glm::dmat4 about(const glm::dvec3& point, const glm::dmat3& rotation) {
  glm::dmat4 turned(rotation);
  turned[3] = glm::dvec4(point - rotation * point, 1.0);
  return turned;
}

/// A joint's turn in the world, after those of its parents.
glm::dmat4 turnInWorld(const Skeleton& skeleton, const Bone& bone, const Pose& pose, const glm::dmat4& carriedBone,
                       const JointTurn& turn, TurnsFrom from) {
  const glm::dmat3 now = frameOf(carriedBone);
  glm::dmat3 start = now;
  if (from == TurnsFrom::kBindPose) {
    const glm::dmat3 bound = boundFrame(skeleton, bone, pose);
    // A rotation cannot undo a clip that mirrors the bone.
    if ((glm::determinant(bound) < 0.0) == (glm::determinant(now) < 0.0)) start = bound;
  }
  const glm::dmat3 rotation = start * glm::mat3_cast(glm::normalize(glm::dquat(turn.turn))) * glm::transpose(now);
  return about(glm::dvec3(carriedBone[3]), rotation);
}

}  // namespace

glm::quat PoseOverrides::turnOf(int bone) const {
  const auto found = std::ranges::lower_bound(turns, bone, {}, &JointTurn::bone);
  return found != turns.end() && found->bone == bone ? found->turn : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
}

void PoseOverrides::set(int bone, const glm::quat& turn) {
  const float length = glm::length(turn);
  const bool usable = length > 0.0f && std::isfinite(length);
  const bool isUnit = std::abs(length - 1.0f) < 1e-6f;  // Setting the same turn again must not change a bit.
  const glm::quat unit = isUnit ? turn : (usable ? turn / length : glm::quat(1.0f, 0.0f, 0.0f, 0.0f));
  const auto found = std::ranges::lower_bound(turns, bone, {}, &JointTurn::bone);
  const bool there = found != turns.end() && found->bone == bone;
  if (unit.x == 0.0f && unit.y == 0.0f && unit.z == 0.0f) {
    if (there) turns.erase(found);
  } else if (there) {
    found->turn = unit;
  } else {
    turns.insert(found, {bone, unit});
  }
}

glm::mat3 turnFrame(const glm::mat4& boneInWorld) { return glm::mat3(frameOf(glm::dmat4(boneInWorld))); }

Pose posed(const Skeleton& skeleton, Pose pose, const PoseOverrides& overrides) {
  if (overrides.isEmpty()) return pose;
  std::vector<std::optional<glm::dmat4>> carried(skeleton.bones.size());  // World -> world; none: untouched.
  auto turn = overrides.turns.begin();
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    const Bone& bone = skeleton.bones[i];
    std::optional<glm::dmat4>& carry = carried[i];
    if (bone.parent >= 0) carry = at(carried, bone.parent);
    const glm::dmat4 sampled(pose.boneInWorld[i]);
    while (turn != overrides.turns.end() && turn->bone < static_cast<int>(i)) ++turn;
    if (turn != overrides.turns.end() && turn->bone == static_cast<int>(i)) {
      const glm::dmat4 before = carry.value_or(glm::dmat4(1.0));
      carry = turnInWorld(skeleton, bone, pose, before * sampled, *turn, overrides.from) * before;
    }
    if (carry) pose.boneInWorld[i] = glm::mat4(*carry * sampled);
  }
  return pose;
}

glm::quat heldTurn(const Skeleton& skeleton, const Pose& pose, int bone) {
  const auto i = static_cast<std::size_t>(bone);
  const glm::dmat3 now = frameOf(glm::dmat4(pose.boneInWorld[i]));
  return glm::quat(glm::quat_cast(glm::transpose(boundFrame(skeleton, skeleton.bones[i], pose)) * now));
}

PoseOverrides startingFrom(TurnsFrom from, const Skeleton& skeleton, const Pose& sampled,
                           const PoseOverrides& overrides) {
  if (from == overrides.from) return overrides;
  const Pose wanted = posed(skeleton, sampled, overrides);
  PoseOverrides result;
  result.from = from;
  for (const JointTurn& turn : overrides.turns) {
    const auto bone = static_cast<std::size_t>(turn.bone);
    if (from == TurnsFrom::kBindPose) {
      result.set(turn.bone, heldTurn(skeleton, wanted, turn.bone));
      continue;
    }
    // The turns of parents are already in `result`.
    const glm::dmat3 start = frameOf(glm::dmat4(posed(skeleton, sampled, result).boneInWorld[bone]));
    const glm::dmat3 goal = frameOf(glm::dmat4(wanted.boneInWorld[bone]));
    result.set(turn.bone, glm::quat(glm::quat_cast(glm::transpose(start) * goal)));
  }
  return result;
}

glm::quat mirroredTurn(const glm::quat& turn, const Bone& bone, const Bone& twin, const glm::vec3& planeNormal) {
  const glm::dvec3 n = unitOr(glm::dvec3(planeNormal), {1.0, 0.0, 0.0});
  const glm::dmat3 mirror = glm::dmat3(1.0) - 2.0 * glm::outerProduct(n, n);
  const glm::dmat3 frame = frameOf(glm::dmat4(bone.bindInWorld));
  const glm::dmat3 inTwin = glm::transpose(frameOf(glm::dmat4(twin.bindInWorld))) * mirror * frame;
  const glm::dquat q(turn);  // A reflection keeps the angle and transforms the axis as a pseudovector.
  const glm::dvec3 axis = glm::determinant(inTwin) * (inTwin * glm::dvec3(q.x, q.y, q.z));
  return glm::quat(glm::normalize(glm::dquat(q.w, axis.x, axis.y, axis.z)));
}

PoseOverrides mirroredPose(const PoseOverrides& overrides, const Skeleton& skeleton, std::span<const int> twinOf,
                           const glm::vec3& planeNormal) {
  PoseOverrides result;
  result.from = overrides.from;
  for (const JointTurn& turn : overrides.turns) {
    const auto bone = static_cast<std::size_t>(turn.bone);
    const int twin = bone < twinOf.size() ? twinOf[bone] : -1;
    if (twin < 0) {
      result.set(turn.bone, turn.turn);
      continue;
    }
    const Bone& other = at(skeleton.bones, twin);
    result.set(twin, mirroredTurn(turn.turn, skeleton.bones[bone], other, planeNormal));
  }
  return result;
}

}  // namespace sinew
