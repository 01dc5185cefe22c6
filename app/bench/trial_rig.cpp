// app/bench/trial_rig.cpp: bones ranked by their skin; an ellipsoid half under the skin of each.
#include "app/bench/trial_rig.h"

#include "app/bench/trial_placement.h"
#include "core/base/split_mix.h"

namespace sinew {
namespace {

/// A vertex beside the middle of the bone, if there is one.
int chosenVertex(const Character& character, const Skin& skin, const Segment& segment, std::uint64_t seed) {
  std::vector<int> beside;
  for (const int v : skin.vertices) {
    const float t = segment.parameter(character.mesh.positions[static_cast<std::size_t>(v)]);
    if (t > 0.2f && t < 0.8f) beside.push_back(v);
  }
  const std::vector<int>& among = beside.empty() ? skin.vertices : beside;
  return among[splitMix64(seed) % among.size()];
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
