// core/character/skeleton.cpp: finds bones; computes paths, children and tips.
#include <algorithm>
#include <map>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/character/bindings.h"
#include "core/character/joint_roles.h"
#include "core/geometry/at.h"
#include "sinew/character/skeleton.h"

namespace sinew {
namespace {

bool nameIsUnique(const Skeleton& skeleton, std::string_view name) {
  return std::ranges::count(skeleton.bones, name, &Bone::name) == 1;
}

void linkChildren(Skeleton& skeleton) {
  for (Bone& bone : skeleton.bones) bone.children.clear();
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    const int parent = skeleton.bones[i].parent;
    if (parent >= 0) at(skeleton.bones, parent).children.push_back(static_cast<int>(i));
  }
}

/// Names from root to bone; siblings with the same name get "#2", "#3" ..., so that paths are unique.
void namePaths(Skeleton& skeleton) {
  std::map<std::string, int> used;
  for (Bone& bone : skeleton.bones) {
    std::string path = bone.name;
    if (bone.parent >= 0) path = at(skeleton.bones, bone.parent).path + "/" + bone.name;
    std::string candidate = path;
    for (int count = used[path] + 1; used.contains(candidate) && used[candidate] > 0; ++count) {
      candidate = path + "#" + std::to_string(count);
    }
    ++used[path];
    if (candidate != path) ++used[candidate];
    bone.path = candidate;
  }
}

glm::vec3 originInWorld(const Bone& bone) { return glm::vec3(bone.bindInWorld[3]); }

/// End of the bone's segment in the bind pose, world space.
glm::vec3 tipInWorld(const Skeleton& skeleton, const Bone& bone) {
  const glm::vec3 origin = originInWorld(bone);
  if (!bone.children.empty()) {
    glm::vec3 sum(0.0f);
    for (const int child : bone.children) sum += originInWorld(at(skeleton.bones, child));
    return sum / static_cast<float>(bone.children.size());
  }
  if (bone.parent < 0) return origin;
  return origin + 0.5f * (origin - originInWorld(at(skeleton.bones, bone.parent)));
}

}  // namespace

glm::mat4 LocalTransform::toMatrix() const {
  if (matrix) return *matrix;
  return glm::scale(glm::translate(glm::mat4(1.0f), translation) * glm::mat4_cast(rotation), scale);
}

std::optional<int> Skeleton::findBone(std::string_view nameOrPath) const {
  const auto byPath = std::ranges::find(bones, nameOrPath, &Bone::path);
  if (nameIsUnique(*this, nameOrPath)) {
    return static_cast<int>(std::ranges::find(bones, nameOrPath, &Bone::name) - bones.begin());
  }
  if (byPath != bones.end()) return static_cast<int>(byPath - bones.begin());
  return std::nullopt;
}

const std::string& Skeleton::fileName(int bone) const {
  const Bone& found = at(bones, bone);
  return nameIsUnique(*this, found.name) ? found.name : found.path;  // findBone() prefers unique names to paths.
}

void finishBones(Skeleton& skeleton) {
  linkChildren(skeleton);
  namePaths(skeleton);
  for (Bone& bone : skeleton.bones) {
    bone.inverseBindInWorld = glm::mat4(glm::inverse(glm::dmat4(bone.bindInWorld)));
  }
  for (Bone& bone : skeleton.bones) {
    const glm::vec3 tip = tipInWorld(skeleton, bone);
    bone.tip = glm::vec3(bone.inverseBindInWorld * glm::vec4(tip, 1.0f));
    if (!isFinite(bone.tip)) bone.tip = glm::vec3(0.0f);
  }
}

// Which bones carry the skin.

std::vector<bool> bonesWithSkin(const Character& character) {
  std::vector<bool> result(character.skeleton.bones.size(), false);
  for (const Influence& influence : character.mesh.influences) {
    if (influence.weight > 0.0f) at(result, at(character.skeleton.bindings, influence.binding).bone) = true;
  }
  return result;
}

std::vector<bool> helperBones(const Character& character) {
  return helperBones(character.skeleton, bonesWithSkin(character));
}

}  // namespace sinew
