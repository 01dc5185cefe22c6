// tests/support/rigs/bedded_rig.cpp: an ellipsoid under the skin, where the surrounding skin follows one bone.
#include "tests/support/rigs/bedded_rig.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/character/bindings.h"
#include "core/rig/trial_rig.h"
#include "sinew/geometry/geometry.h"

namespace sinew::test {
namespace {

constexpr float kOwnSkin = 0.9f;     ///< Weight on its bone from which skin is its own.
constexpr float kLeastRoom = 0.03f;  ///< Fractions of H.
constexpr float kDeepest = 0.04f;
constexpr float kBedded = 0.7f;  ///< Depth of its middle, fraction of its thickness.

/// The vertex's weight on one bone.
float weightOn(const Character& character, int vertex, int bone) {
  float sum = 0.0f;
  for (const WeightedBinding& follows : bindingsOf(character, vertex)) {
    if (follows.bone() == bone) sum += follows.weight;
  }
  return sum;
}

/// A place for a muscle: a vertex, and the distance within which the skin still follows the bone.
struct Bed {
  int vertex = 0;
  float free = 0.0f;
};

/// Vertices of a bone's skin with room around them, in descending order of room. Room ends where other bones have
/// weight.
std::vector<Bed> bedsOf(const Character& character, const Skin& skin) {
  std::vector<glm::vec3> foreign;
  const ControlMesh& mesh = character.mesh;
  for (int v = 0; v < static_cast<int>(mesh.positions.size()); ++v) {
    if (weightOn(character, v, skin.bone) < kOwnSkin) foreign.push_back(mesh.positions[static_cast<std::size_t>(v)]);
  }
  std::vector<Bed> beds;
  for (const int v : skin.vertices) {
    float nearest = kLongestTrial * character.height;
    for (const glm::vec3& other : foreign) {
      nearest = std::min(nearest, glm::distance(other, mesh.positions[static_cast<std::size_t>(v)]));
    }
    beds.push_back({v, nearest});
  }
  std::ranges::stable_sort(beds, std::ranges::greater{}, &Bed::free);
  return beds;
}

/// Most of its thickness lies under the skin, its influence within the room.
Placement bedded(const Character& character, const Bone& bone, const Bed& bed) {
  const Segment segment = bindSegment(bone);
  Placement placement = placementAt(character, bone, segment, bed.vertex);
  const float height = character.height;
  const glm::vec3 point = character.mesh.positions[static_cast<std::size_t>(bed.vertex)];
  const glm::vec3 out = normalizeOr(character.mesh.normals[static_cast<std::size_t>(bed.vertex)], {0.0f, 1.0f, 0.0f});
  const float room = std::clamp(bed.free / kDefaultReach, 0.3f * kThinnestTrial * height, kLongestTrial * height);
  const float thick = std::min({room, kDeepest * height, 0.7f * segment.distance(point)});
  const float half = std::clamp(0.4f * glm::length(segment.along), thick, std::max(room, thick));
  glm::mat3 bind(bone.bindInWorld);
  const float scale = std::cbrt(std::abs(glm::determinant(bind)));
  placement.center = glm::vec3(bone.inverseBindInWorld * glm::vec4(point - kBedded * thick * out, 1.0f));
  placement.radii = glm::vec3(half, thick, 0.8f * thick) / (scale > 0.0f ? scale : 1.0f);
  return placement;
}

}  // namespace

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

}  // namespace sinew::test
