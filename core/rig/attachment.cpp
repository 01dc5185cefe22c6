// core/rig/attachment.cpp: names -> indices, territories -> weights per control vertex.
#include "core/rig/attachment.h"

#include <algorithm>

#include "core/base/at.h"
#include "core/base/smoothstep.h"
#include "core/character/bindings.h"
#include "core/primitives/potential.h"

namespace sinew {
namespace {

Result<const BlendingGraph*> graphOf(const Rig& rig, BlendingGraphMemo& graphs) {
  std::vector<std::array<int, 2>> links;
  for (const auto& [a, b] : rig.links) links.push_back({findGroup(rig, a), findGroup(rig, b)});
  return graphs.graph(static_cast<int>(rig.groups.size()), links);
}

void shape(const Rig& rig, const Primitive& primitive, FieldPrimitive& field) {
  field.placement = primitive.placement;
  field.reach = primitive.reach;
  field.strength = static_cast<float>(primitive.sign) * strengthFor(rig.surface.iso, primitive.reach);
}

FieldPrimitive fieldPrimitive(const Rig& rig, const Primitive& primitive, int bone) {
  FieldPrimitive field;
  field.bone = bone;
  shape(rig, primitive, field);
  field.group = findGroup(rig, primitive.group);
  return field;
}

/// Appends primitive `index` to the vertices its territory holds.
void addCandidates(const Character& character, const std::vector<int>& territory, int index,
                   std::vector<std::vector<Candidate>>& candidatesOfVertex) {
  std::vector<bool> isTerritoryBone(character.skeleton.bones.size(), false);
  for (const int bone : territory) at(isTerritoryBone, bone) = true;
  for (std::size_t v = 0; v < candidatesOfVertex.size(); ++v) {
    const float weight = territoryWeight(character, static_cast<int>(v), isTerritoryBone);
    if (weight > 0.0f) candidatesOfVertex[v].push_back({index, weight, 0});
  }
}

}  // namespace

std::vector<Error> missingBones(const Rig& rig, const Skeleton& skeleton) {
  std::vector<Error> missing;
  const auto check = [&](const std::string& bone, const std::string& place, const std::string& subject) {
    if (skeleton.findBone(bone)) return;
    missing.push_back(errorAt(place, "this character has no bone \"" + bone + '"', subject));
  };
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& primitive = rig.primitives[i];
    const std::string place = "primitives[" + std::to_string(i) + "]";
    const std::string subject = "muscle \"" + primitive.name + '"';
    check(primitive.bone, place + ".bone", subject);
    if (!primitive.territory) continue;
    for (std::size_t t = 0; t < primitive.territory->size(); ++t) {
      check((*primitive.territory)[t], place + ".territory[" + std::to_string(t) + "]", subject + ", territory");
    }
  }
  return missing;
}

std::vector<int> territoryBones(const Primitive& primitive, int bone, const Skeleton& skeleton) {
  std::vector<int> bones;
  if (primitive.territory) {
    for (const std::string& name : *primitive.territory) {
      if (const std::optional<int> found = skeleton.findBone(name)) bones.push_back(*found);
    }
  } else {
    const Bone& own = at(skeleton.bones, bone);
    bones = own.children;
    bones.push_back(bone);
    if (own.parent >= 0) bones.push_back(own.parent);
  }
  std::ranges::sort(bones);
  bones.erase(std::ranges::unique(bones).begin(), bones.end());
  return bones;
}

float territoryWeight(const Character& character, int vertex, const std::vector<bool>& isTerritoryBone) {
  float sum = 0.0f;
  for (const WeightedBinding& follows : bindingsOf(character, vertex)) {
    if (at(isTerritoryBone, follows.bone())) sum += follows.weight;
  }
  return smoothstep(0.0f, 0.5f, sum);
}

bool sameCandidates(const Rig& a, const Rig& b) {
  const auto sameGroup = [](const Group& x, const Group& y) { return x.name == y.name; };
  const auto samePlace = [](const Primitive& x, const Primitive& y) {
    return x.bone == y.bone && x.group == y.group && x.territory == y.territory;
  };
  return std::ranges::equal(a.primitives, b.primitives, samePlace) && a.links == b.links &&
         std::ranges::equal(a.groups, b.groups, sameGroup);
}

void reshape(const Rig& rig, Attachment& attachment) {
  for (std::size_t i = 0; i < attachment.primitives.size(); ++i) {
    const Primitive& primitive = at(rig.primitives, attachment.rigIndex[i]);
    shape(rig, primitive, attachment.primitives[i]);
  }
}

Result<Attachment> attach(const Rig& rig, const Character& character) {
  BlendingGraphMemo graphs;
  return attach(rig, character, graphs);
}

Result<Attachment> attach(const Rig& rig, const Character& character, BlendingGraphMemo& graphs) {
  const Result<const BlendingGraph*> graph = graphOf(rig, graphs);
  if (!graph) return graph.error();
  Attachment attachment;
  attachment.graph = *graph.value();
  attachment.candidatesOfVertex.resize(character.mesh.positions.size());
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& primitive = rig.primitives[i];
    const std::optional<int> bone = character.skeleton.findBone(primitive.bone);
    if (!bone) {
      attachment.unattached.push_back(static_cast<int>(i));
      continue;
    }
    const int index = static_cast<int>(attachment.primitives.size());
    attachment.primitives.push_back(fieldPrimitive(rig, primitive, *bone));
    attachment.rigIndex.push_back(static_cast<int>(i));
    addCandidates(character, territoryBones(primitive, *bone, character.skeleton), index,
                  attachment.candidatesOfVertex);
  }
  return attachment;
}

}  // namespace sinew
