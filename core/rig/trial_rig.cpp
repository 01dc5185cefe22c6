// core/rig/trial_rig.cpp: ranks bones by the area of their skin and places an ellipsoid at each.
#include "core/rig/trial_rig.h"

#include <algorithm>
#include <cmath>

#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "core/geometry/index_table.h"
#include "sinew/geometry/geometry.h"

namespace sinew {
namespace {

/// A vertex beside the middle of the bone, if there is any.
int chosenVertex(const Character& character, const Skin& skin, const Segment& segment, std::uint64_t seed) {
  std::vector<int> beside;
  for (const int v : skin.vertices) {
    const float t = segment.parameter(at(character.mesh.positions, v));
    if (t > 0.2f && t < 0.8f) beside.push_back(v);
  }
  const std::vector<int>& among = beside.empty() ? skin.vertices : beside;
  return among[splitMix64(seed) % among.size()];
}

}  // namespace

std::vector<Skin> skinsOf(const Character& character) {
  std::vector<Skin> skins(character.skeleton.bones.size());
  for (std::size_t b = 0; b < skins.size(); ++b) skins[b].bone = static_cast<int>(b);
  std::vector<int> boneOf;
  const ControlMesh& mesh = character.mesh;
  for (int v = 0; v < static_cast<int>(mesh.positions.size()); ++v) {
    boneOf.push_back(strongestBone(character, v));
    at(skins, boneOf.back()).vertices.push_back(v);
  }
  for (const ControlTriangle& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t i) { return at(mesh.positions, triangle.vertices[i]); };
    const float third = glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0))) / 6.0f;
    for (const int v : triangle.vertices) at(skins, at(boneOf, v)).area += third;
  }
  std::erase_if(skins, [](const Skin& skin) { return !(skin.area > 0.0f); });
  std::ranges::stable_sort(skins, std::ranges::greater{}, &Skin::area);
  return skins;
}

Placement placementAt(const Character& character, const Bone& bone, const Segment& segment, int vertex) {
  const float height = character.height;
  const glm::vec3 point = at(character.mesh.positions, vertex);
  const glm::vec3 out = at(character.mesh.normals, vertex);
  const float limb = std::clamp(segment.distance(point), kThinnestTrial * height, kThickestTrial * height);
  const float length = std::clamp(0.4f * glm::length(segment.along), limb, kLongestTrial * height);
  const glm::vec3 sideways = normalizeOr(glm::cross(segment.along, out), {0.0f, 0.0f, 1.0f});
  const glm::vec3 upwards = normalizeOr(out, {0.0f, 1.0f, 0.0f});
  const glm::vec3 along = normalizeOr(glm::cross(upwards, sideways), {1.0f, 0.0f, 0.0f});
  const glm::mat3 axes(along, upwards, glm::cross(along, upwards));

  glm::mat3 bind(bone.bindInWorld);
  const float scale = std::cbrt(std::abs(glm::determinant(bind)));
  for (int column = 0; column < 3; ++column) bind[column] = normalizeOr(bind[column], glm::vec3(0.0f));
  Placement placement;
  placement.center = glm::vec3(bone.inverseBindInWorld * glm::vec4(point - 0.4f * limb * upwards, 1.0f));
  placement.rotation = glm::normalize(glm::quat_cast(glm::transpose(bind) * axes));
  placement.radii = glm::vec3(length, 0.7f * limb, 0.85f * limb) / (scale > 0.0f ? scale : 1.0f);
  return placement;
}

Rig trialRig(const Character& character, int muscles, std::uint64_t seed) {
  Rig rig;
  for (const char* group : {"a", "b", "c"}) rig.groups.push_back({group, {}});
  rig.links = {{{"a", "b"}}, {{"b", "c"}}};
  const std::vector<Skin> skins = skinsOf(character);
  for (int i = 0; i < muscles && !skins.empty(); ++i) {
    const Skin& skin = skins[static_cast<std::size_t>(i) % skins.size()];
    const Bone& bone = at(character.skeleton.bones, skin.bone);
    const Segment segment = bindSegment(bone);
    const int vertex = chosenVertex(character, skin, segment, splitMix64(seed) + static_cast<std::uint64_t>(i));
    Primitive primitive;
    primitive.name = "muscle " + std::to_string(i + 1);
    primitive.bone = character.skeleton.fileName(skin.bone);
    primitive.group = rig.groups[static_cast<std::size_t>(i) % rig.groups.size()].name;
    primitive.placement = placementAt(character, bone, segment, vertex);
    rig.primitives.push_back(std::move(primitive));
  }
  return rig;
}

}  // namespace sinew
