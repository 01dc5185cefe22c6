// core/character/pose_check.cpp: counts and finite numbers of a pose.
#include "sinew/character/pose_check.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

bool hasAllBones(const Character& character, const Pose& pose) {
  return pose.boneInWorld.size() >= character.skeleton.bones.size();
}

bool hasAllMorphs(const Character& character, const Pose& pose) {
  return pose.morphWeights.empty() || pose.morphWeights.size() == character.morphTargets.size();
}

bool isFiniteMatrix(const glm::mat4& matrix) { return isFinite(matrix); }
bool isFiniteNumber(float number) { return std::isfinite(number); }

}  // namespace

bool isSoundPose(const Character& character, const Pose& pose) {
  return hasAllBones(character, pose) && hasAllMorphs(character, pose) &&
         std::ranges::all_of(pose.boneInWorld, isFiniteMatrix) &&
         std::ranges::all_of(pose.morphWeights, isFiniteNumber) && std::isfinite(pose.flex) && std::isfinite(pose.time);
}

Result<void> checkPose(const Character& character, const Pose& pose) {
  const auto& bones = character.skeleton.bones;
  if (!hasAllBones(character, pose)) {
    return errorAt("pose", "expected matrices of " + std::to_string(bones.size()) + " bones, got " +
                               std::to_string(pose.boneInWorld.size()));
  }
  const auto odd = std::ranges::find_if_not(pose.boneInWorld, isFiniteMatrix);
  if (odd != pose.boneInWorld.end()) {
    const auto index = static_cast<std::size_t>(odd - pose.boneInWorld.begin());
    const std::string name = index < bones.size() ? " \"" + bones[index].name + '"' : std::string();
    return errorAt("bone " + std::to_string(index) + name, "its matrix has a number that is not finite");
  }
  if (!hasAllMorphs(character, pose)) {
    return errorAt("pose", "expected weights of " + std::to_string(character.morphTargets.size()) +
                               " morph targets or none, got " + std::to_string(pose.morphWeights.size()));
  }
  if (!std::ranges::all_of(pose.morphWeights, isFiniteNumber)) {
    return errorAt("pose", "a morph target's weight is not finite");
  }
  if (!std::isfinite(pose.flex)) return errorAt("pose", "the flex is not finite");
  if (!std::isfinite(pose.time)) return errorAt("pose", "the time is not finite");
  return {};
}

}  // namespace sinew
