// core/character/local_pose.cpp: local transforms -> world matrices, parents first.
#include "sinew/character/local_pose.h"

#include <algorithm>
#include <cmath>

#include "core/character/node_world.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

bool isFiniteTurn(const glm::quat& q) {
  return std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

template <class T, class IsFinite>
Result<void> checkLocals(const char* name, std::span<const T> list, std::size_t bones, IsFinite isFiniteItem) {
  if (list.empty()) return {};
  if (list.size() != bones) {
    return errorAt(name, "expected one for each of " + std::to_string(bones) + " bones or none, got " +
                             std::to_string(list.size()));
  }
  const auto odd = std::ranges::find_if_not(list, isFiniteItem);
  if (odd == list.end()) return {};
  return errorAt(std::string(name) + "[" + std::to_string(odd - list.begin()) + "]", "expected finite numbers");
}

Result<void> checkLocals(const Skeleton& skeleton, const BoneLocals& locals) {
  const auto isFinitePoint = [](const glm::vec3& v) { return isFinite(v); };
  const std::size_t bones = skeleton.bones.size();
  if (auto fits = checkLocals("rotations", locals.rotations, bones, isFiniteTurn); !fits) return fits;
  if (auto fits = checkLocals("translations", locals.translations, bones, isFinitePoint); !fits) return fits;
  if (auto fits = checkLocals("scales", locals.scales, bones, isFinitePoint); !fits) return fits;
  const bool none = locals.rotations.empty() && locals.translations.empty() && locals.scales.empty();
  const bool all = !locals.rotations.empty() && !locals.translations.empty() && !locals.scales.empty();
  if (none || all) return {};
  for (const Bone& bone : skeleton.bones) {
    if (at(skeleton.nodes, bone.node).rest.matrix) {
      return errorAt("bone \"" + bone.name + '"',
                     "it rests by a matrix: give rotations, translations and scales, or none of them");
    }
  }
  return {};
}

}  // namespace

Result<void> poseFromLocals(const Skeleton& skeleton, const BoneLocals& locals, std::vector<glm::dmat4>& scratch,
                            Pose& out) {
  if (Result<void> sound = checkLocals(skeleton, locals); !sound) return sound;
  scratch.resize(skeleton.nodes.size());
  for (std::size_t n = 0; n < skeleton.nodes.size(); ++n) scratch[n] = glm::dmat4(skeleton.nodes[n].rest.toMatrix());
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const int node = skeleton.bones[b].node;
    LocalTransform local = at(skeleton.nodes, node).rest;
    if (!locals.rotations.empty()) local.rotation = locals.rotations[b];
    if (!locals.translations.empty()) local.translation = locals.translations[b];
    if (!locals.scales.empty()) local.scale = locals.scales[b];
    if (!locals.rotations.empty()) local.matrix.reset();  // All three are there, where it had one.
    at(scratch, node) = glm::dmat4(local.toMatrix());
  }
  followParents(skeleton, scratch, out.boneInWorld);
  return {};
}

Result<Pose> poseFromLocals(const Skeleton& skeleton, const BoneLocals& locals) {
  std::vector<glm::dmat4> scratch;
  Pose pose;
  if (Result<void> made = poseFromLocals(skeleton, locals, scratch, pose); !made) return made.error();
  return pose;
}

}  // namespace sinew
