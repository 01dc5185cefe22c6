// core/rig/trial_rig.cpp: bones ranked by their skin; an ellipsoid half under the skin of each.
#include "core/rig/trial_rig.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

namespace sinew {
namespace {

constexpr float kThinnest = 0.015f;  ///< Fractions of H.
constexpr float kThickest = 0.06f;
constexpr float kLongest = 0.12f;

/// SplitMix64: the standard library's distributions differ from machine to machine.
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15ull;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ull;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebull;
  return value ^ (value >> 31);
}

/// The skin that follows one bone more than any other.
struct Skin {
  int bone = 0;
  float area = 0.0f;
  std::vector<int> vertices;
};

int strongestBone(const Character& character, int vertex) {
  const auto influences = character.mesh.influencesOf(vertex);
  const auto strongest = std::ranges::max_element(influences, {}, &Influence::weight);
  return character.skeleton.bindings[static_cast<std::size_t>(strongest->binding)].bone;
}

/// Bones that have skin, the one with the most first.
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

/// A bone's segment in the bind pose, world.
struct Segment {
  glm::vec3 from{0.0f};
  glm::vec3 along{0.0f};

  explicit Segment(const Bone& bone)
      : from(bone.bindInWorld[3]), along(glm::vec3(bone.bindInWorld * glm::vec4(bone.tip, 1.0f)) - from) {}

  float parameter(const glm::vec3& point) const {
    const float span = glm::dot(along, along);
    return span > 0.0f ? glm::dot(point - from, along) / span : 0.0f;
  }
  float distance(const glm::vec3& point) const {
    return glm::distance(point, from + along * std::clamp(parameter(point), 0.0f, 1.0f));
  }
};

/// A vertex beside the middle of the bone, if there is one.
int chosenVertex(const Character& character, const Skin& skin, const Segment& segment, std::uint64_t seed) {
  std::vector<int> beside;
  for (const int v : skin.vertices) {
    const float t = segment.parameter(character.mesh.positions[static_cast<std::size_t>(v)]);
    if (t > 0.2f && t < 0.8f) beside.push_back(v);
  }
  const std::vector<int>& among = beside.empty() ? skin.vertices : beside;
  return among[mixed(seed) % among.size()];
}

Placement placementAt(const Character& character, const Bone& bone, const Segment& segment, int vertex) {
  const float height = character.height;
  const glm::vec3 point = character.mesh.positions[static_cast<std::size_t>(vertex)];
  const glm::vec3 out = character.mesh.normals[static_cast<std::size_t>(vertex)];
  const float limb = std::clamp(segment.distance(point), kThinnest * height, kThickest * height);
  const float length = std::clamp(0.4f * glm::length(segment.along), limb, kLongest * height);
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

}  // namespace

Rig trialRig(const Character& character, int muscles, std::uint64_t seed) {
  Rig rig;
  for (const char* group : {"a", "b", "c"}) rig.groups.push_back({group, {}});
  rig.links = {{"a", "b"}, {"b", "c"}};
  const std::vector<Skin> skins = skinsOf(character);
  for (int i = 0; i < muscles && !skins.empty(); ++i) {
    const Skin& skin = skins[static_cast<std::size_t>(i) % skins.size()];
    const Bone& bone = character.skeleton.bones[static_cast<std::size_t>(skin.bone)];
    const Segment segment(bone);
    const int vertex = chosenVertex(character, skin, segment, mixed(seed) + static_cast<std::uint64_t>(i));
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
