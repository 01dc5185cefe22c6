// app/cli/trial_rig.cpp: bones ranked by their skin; an ellipsoid half under the skin of each.
#include "app/cli/trial_rig.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

namespace sinew {
namespace {

constexpr float kThinnest = 0.015f;  ///< Fractions of H.
constexpr float kThickest = 0.06f;
constexpr float kLongest = 0.12f;
// Of a bedded muscle.
constexpr float kOwnSkin = 0.9f;     ///< Weight on its bone from which skin is its own.
constexpr float kLeastRoom = 0.03f;  ///< Fractions of H.
constexpr float kDeepest = 0.04f;
constexpr float kBedded = 0.7f;  ///< Of its thickness, how deep its middle lies.

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

/// The vertex's weight on one bone.
float weightOn(const Character& character, int vertex, int bone) {
  float sum = 0.0f;
  for (const Influence& influence : character.mesh.influencesOf(vertex)) {
    if (character.skeleton.bindings[static_cast<std::size_t>(influence.binding)].bone == bone) sum += influence.weight;
  }
  return sum;
}

/// A place for a muscle: a vertex and how far from it the skin still follows the bone.
struct Bed {
  int vertex = 0;
  float free = 0.0f;
};

/// Vertices of a bone's skin with room around them, roomiest first. Room ends where other bones have a say.
std::vector<Bed> bedsOf(const Character& character, const Skin& skin) {
  std::vector<glm::vec3> foreign;
  const ControlMesh& mesh = character.mesh;
  for (int v = 0; v < static_cast<int>(mesh.positions.size()); ++v) {
    if (weightOn(character, v, skin.bone) < kOwnSkin) foreign.push_back(mesh.positions[static_cast<std::size_t>(v)]);
  }
  std::vector<Bed> beds;
  for (const int v : skin.vertices) {
    float nearest = kLongest * character.height;
    for (const glm::vec3& other : foreign) {
      nearest = std::min(nearest, glm::distance(other, mesh.positions[static_cast<std::size_t>(v)]));
    }
    beds.push_back({v, nearest});
  }
  std::ranges::stable_sort(beds, std::ranges::greater{}, &Bed::free);
  return beds;
}

/// Under the skin by most of its thickness, its influence within the room.
Placement bedded(const Character& character, const Bone& bone, const Bed& bed) {
  const Segment segment(bone);
  Placement placement = placementAt(character, bone, segment, bed.vertex);
  const float height = character.height;
  const glm::vec3 point = character.mesh.positions[static_cast<std::size_t>(bed.vertex)];
  const glm::vec3 out = normalizeOr(character.mesh.normals[static_cast<std::size_t>(bed.vertex)], {0.0f, 1.0f, 0.0f});
  const float room = std::clamp(bed.free / kDefaultReach, 0.3f * kThinnest * height, kLongest * height);
  const float thick = std::min({room, kDeepest * height, 0.7f * segment.distance(point)});
  const float half = std::clamp(0.4f * glm::length(segment.along), thick, std::max(room, thick));
  glm::mat3 bind(bone.bindInWorld);
  const float scale = std::cbrt(std::abs(glm::determinant(bind)));
  placement.center = glm::vec3(bone.inverseBindInWorld * glm::vec4(point - kBedded * thick * out, 1.0f));
  placement.radii = glm::vec3(half, thick, 0.8f * thick) / (scale > 0.0f ? scale : 1.0f);
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

Rig beddedRig(const Character& character, int muscles) {
  Rig rig;
  rig.groups = {{"muscles", {}}};
  std::vector<std::pair<int, std::vector<Bed>>> bones;
  for (const Skin& skin : skinsOf(character)) {
    std::vector<Bed> beds = bedsOf(character, skin);
    if (beds.front().free >= kLeastRoom * character.height) bones.emplace_back(skin.bone, std::move(beds));
  }
  std::ranges::stable_sort(bones, std::ranges::greater{}, [](const auto& bone) { return bone.second.front().free; });
  for (int i = 0; i < muscles && !bones.empty(); ++i) {
    const auto& [bone, beds] = bones[static_cast<std::size_t>(i) % bones.size()];
    const std::size_t turn = static_cast<std::size_t>(i) / bones.size();
    Primitive primitive;
    primitive.name = "muscle " + std::to_string(i + 1);
    primitive.bone = character.skeleton.fileName(bone);
    primitive.group = "muscles";
    primitive.territory = std::vector<std::string>{primitive.bone};
    primitive.placement =
        bedded(character, character.skeleton.bones[static_cast<std::size_t>(bone)], beds[turn % beds.size()]);
    rig.primitives.push_back(std::move(primitive));
  }
  return rig;
}

}  // namespace sinew
