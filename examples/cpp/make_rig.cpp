// examples/cpp/make_rig.cpp: a rig made in code: a group, a muscle, its mirror image. make_rig humanoid.glb
// OUT.rig.json
#include <cstdio>

#include <glm/gtc/matrix_transform.hpp>

#include "sinew/sinew.h"

namespace {

int fail(const sinew::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 1;
}

/// An upper arm's biceps: an ellipsoid along the bone, in front of its middle. In the bone's own space.
sinew::Primitive biceps(const sinew::Bone& bone) {
  const float length = glm::length(bone.tip);
  const glm::vec3 along = bone.tip / length;
  const glm::vec3 forward = glm::mat3(bone.inverseBindInWorld) * glm::vec3(0.0f, 0.0f, 1.0f);  // As glTF has it: +Z.
  const glm::vec3 side = glm::normalize(glm::cross(along, forward));
  const glm::vec3 front = glm::cross(side, along);
  sinew::Primitive muscle;
  muscle.name = "biceps L";
  muscle.bone = bone.name;
  muscle.group = "arms";
  muscle.placement.center = 0.5f * bone.tip + 0.1f * length * front;
  muscle.placement.rotation = glm::quat_cast(glm::mat3(side, along, front));
  muscle.placement.radii = {0.12f * length, 0.38f * length, 0.14f * length};  // Along side, bone and front.
  muscle.reach = sinew::kNewReach;
  return muscle;
}

/// Its image on the other side of the plane x = 0 of the bind pose.
sinew::Primitive mirrored(const sinew::Primitive& muscle, const sinew::Bone& bone, const sinew::Bone& twinBone) {
  const glm::mat4 flip = glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f, 1.0f, 1.0f));
  const glm::mat4 toTwin = twinBone.inverseBindInWorld * flip * bone.bindInWorld;
  sinew::Primitive twin = muscle;
  twin.bone = twinBone.name;
  twin.placement.center = glm::vec3(toTwin * glm::vec4(muscle.placement.center, 1.0f));
  // A reflection is no rotation; with the ellipsoid's own x turned round as well, which it does not show, it is one.
  const glm::mat3 axes = glm::mat3(toTwin) * glm::mat3_cast(muscle.placement.rotation) * glm::mat3(flip);
  twin.placement.rotation = glm::normalize(glm::quat_cast(axes));
  return twin;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: make_rig CHARACTER.glb OUT.rig.json\n");
    return 2;
  }
  const auto character = sinew::importGltf(argv[1]);
  if (!character) return fail(character.error());
  const sinew::Skeleton& skeleton = character.value()->skeleton;
  const auto left = skeleton.findBone("upper_arm.L"), right = skeleton.findBone("upper_arm.R");
  if (!left || !right) return fail({argv[1], "upper_arm.L, upper_arm.R", "no such bones"});
  const sinew::Bone& bone = skeleton.bones[static_cast<std::size_t>(*left)];

  sinew::Rig rig;
  rig.character = sinew::relativeCharacterPath(argv[1], argv[2]);
  rig.groups.emplace_back().name = "arms";
  rig.primitives = {biceps(bone)};
  rig.primitives.push_back(mirrored(rig.primitives[0], bone, skeleton.bones[static_cast<std::size_t>(*right)]));
  rig.primitives[1].name = "biceps R";
  rig.primitives[0].mirror = "biceps R";  // Linked: an edit of one in the editor moves the other.
  rig.primitives[1].mirror = "biceps L";

  // A Smoother checks the whole rig, as loadRig does.
  sinew::Smoother smoother(character.value());
  if (const auto prepared = smoother.prepare(rig); !prepared) return fail(prepared.error());
  if (const auto saved = sinew::saveRig(rig, argv[2]); !saved) return fail(saved.error());
  std::printf("%s: %zu muscles\n", argv[2], rig.primitives.size());
  return 0;
}
