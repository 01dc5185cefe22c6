// core/files/gltf/vrm_character.cpp: nodes to bones, binds to targets.
#include "core/files/gltf/vrm_character.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "core/character/body_slots.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"

namespace sinew::gltf {
namespace {

constexpr std::size_t kMaxBinds = 65536;  ///< Of all expressions together.

/// "leftUpperArm" -> "upperArm.L"
std::string slotName(const std::string& bone) {
  for (const auto& [side, ending] : {std::pair{"left", ".L"}, std::pair{"right", ".R"}}) {
    if (!bone.starts_with(side) || bone.size() == std::string(side).size()) continue;
    std::string name = bone.substr(std::string(side).size());
    name[0] = toLower(name[0]);
    return name + ending;
  }
  return bone;
}

int boneOfNode(const BoundSkeleton& bound, int node) {
  if (node < 0 || toIndex(node) >= bound.skeletonNode.size()) return -1;
  const int own = at(bound.skeletonNode, node);
  const auto bone = std::ranges::find(bound.skeleton.bones, own, &Bone::node);
  if (own < 0 || bone == bound.skeleton.bones.end()) return -1;
  return static_cast<int>(bone - bound.skeleton.bones.begin());
}

}  // namespace

std::vector<BodyPart> bodyPartsOf(const Vrm& vrm, const BoundSkeleton& bound, Notes& notes) {
  std::vector<BodyPart> parts;
  std::set<std::string> known;
  for (const Vrm::HumanBone& bone : vrm.bones) {
    const std::string slot = slotName(bone.name);
    if (!bodySlotNamed(slot)) continue;
    const int found = boneOfNode(bound, bone.node);
    if (found < 0) notes.add("parts of the body that the file gives to nodes without skin are ignored");
    else if (known.insert(slot).second) parts.push_back({slot, found});
  }
  return parts;
}

std::vector<MorphSet> morphSetsOf(const Vrm& vrm, const NodeTree& tree, std::span<const MorphTarget> targets) {
  std::set<std::string> taken;
  for (const MorphTarget& target : targets) taken.insert(target.name);
  const std::vector<NodeTargets> ofNodes = targetsOfNodes(tree.nodes.size(), targets);
  std::vector<MorphSet> sets;
  std::size_t shares = 0;
  for (const Vrm::Expression& expression : vrm.expressions) {
    MorphSet set;
    set.name = taken.contains(expression.name) ? expression.name + " (expression)" : expression.name;
    for (const Vrm::Bind& bind : expression.binds) {
      for (std::size_t node = 0; node < ofNodes.size() && bind.target >= 0; ++node) {
        const bool meant = bind.mesh >= 0 ? tree.nodes[node].mesh == bind.mesh : static_cast<int>(node) == bind.node;
        if (!meant || bind.target >= ofNodes[node].count || bind.weight == 0.0f) continue;
        if (++shares <= kMaxBinds) set.shares.push_back({ofNodes[node].first + bind.target, bind.weight});
      }
    }
    const bool usable = !set.shares.empty() && !set.name.empty() && sets.size() < kMaxMorphTargets;
    if (usable && taken.insert(set.name).second) sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace sinew::gltf
