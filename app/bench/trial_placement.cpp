// app/bench/trial_placement.cpp: bones ranked by their skin; an ellipsoid half under the skin.
#include "app/bench/trial_placement.h"

#include <algorithm>
#include <cmath>

#include "core/character/bindings.h"
#include "sinew/base/geometry.h"

namespace sinew {
std::vector<Skin> skinsOf(const Character& character) {
  std::vector<Skin> skins(character.skeleton.bones.size());
  for (std::size_t b = 0; b < skins.size(); ++b) skins[b].bone = static_cast<int>(b);
  std::vector<std::size_t> boneOf;
  const ControlMesh& mesh = character.mesh;
  for (int v = 0; v < static_cast<int>(mesh.positions.size()); ++v) {
    boneOf.push_back(static_cast<std::size_t>(strongestBone(character, v)));
    skins[boneOf.back()].vertices.push_back(v);
  }
  for (const ControlTriangle& triangle : mesh.triangles) {
    const auto at = [&](std::size_t i) { return mesh.positions[static_cast<std::size_t>(triangle.vertices[i])]; };
    const float third = glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 6.0f;
    for (const int v : triangle.vertices) skins[boneOf[static_cast<std::size_t>(v)]].area += third;
  }
  std::erase_if(skins, [](const Skin& skin) { return !(skin.area > 0.0f); });
  std::ranges::stable_sort(skins, std::ranges::greater{}, &Skin::area);
  return skins;
}

Placement placementAt(const Character& character, const Bone& bone, const Segment& segment, int vertex) {
  const float height = character.height;
  const glm::vec3 point = character.mesh.positions[static_cast<std::size_t>(vertex)];
  const glm::vec3 out = character.mesh.normals[static_cast<std::size_t>(vertex)];
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

}  // namespace sinew
