// core/files/fit/candidates.cpp: joints of a vertex, of the muscles over it and of its surroundings, in that order.
#include "core/files/fit/candidates.h"

#include <algorithm>

#include "core/character/skin_bones.h"
#include "core/files/fit/best_weights.h"
#include "core/geometry/at.h"
#include "core/rig/attachment.h"

namespace sinew::exporting {
namespace {

/// The control mesh with other influences: [V] lists of shares become its weights.
ControlMesh following(const ControlMesh& mesh, const std::vector<std::vector<Share>>& shares) {
  ControlMesh result;
  result.positions = mesh.positions;
  result.edges = mesh.edges;
  result.triangles = mesh.triangles;
  result.influenceBegin.push_back(0);
  for (const std::vector<Share>& list : shares) {
    for (const Share& share : list) result.influences.push_back({share.binding, static_cast<float>(share.weight)});
    result.influenceBegin.push_back(static_cast<int>(result.influences.size()));
  }
  return result;
}

void add(std::vector<Share>& shares, int binding, double weight) {
  const auto place = std::ranges::lower_bound(shares, binding, {}, &Share::binding);
  if (place != shares.end() && place->binding == binding) place->weight += weight;
  else shares.insert(place, {binding, weight});
}

/// [V] what the neighbors of each control vertex follow.
std::vector<std::vector<Share>> ringShares(const ControlMesh& mesh) {
  std::vector<std::vector<Share>> result(mesh.positions.size());
  for (const Edge& edge : mesh.edges) {
    for (const int end : {0, 1}) {
      for (const Influence& influence : mesh.influencesOf(edge.vertices[toIndex(1 - end)])) {
        add(at(result, at(edge.vertices, end)), influence.binding, static_cast<double>(influence.weight));
      }
    }
  }
  return result;
}

/// [V] bones of the muscles that reach each control vertex, each with the muscle's nearness in radii.
std::vector<std::vector<Share>> muscleShares(const Character& character, const Rig& rig, const Attachment& attachment) {
  const Skeleton& skeleton = character.skeleton;
  std::vector<std::vector<Share>> result(character.mesh.positions.size());
  for (std::size_t v = 0; v < result.size(); ++v) {
    for (const Candidate& candidate : attachment.candidatesOfVertex[v]) {
      const Primitive& primitive = at(rig.primitives, at(attachment.rigIndex, candidate.primitive));
      const int bone = at(attachment.primitives, candidate.primitive).bone;
      const glm::vec3 center(at(skeleton.bones, bone).bindInWorld * glm::vec4(primitive.placement.center, 1.0f));
      const glm::vec3& radii = primitive.placement.radii;
      const float reach = primitive.reach * std::max({radii.x, radii.y, radii.z});
      const float distance = glm::length(character.mesh.positions[v] - center);
      if (!(distance < reach)) continue;
      const double nearness = 1.0 - static_cast<double>(distance / reach);
      add(result[v], bone, nearness);
      const MuscleLine* line = lineOf(rig, primitive);
      if (!line) continue;
      for (const LineAnchor* anchor : {&line->origin, &line->insertion}) {
        if (const auto end = skeleton.findBone(anchor->bone)) add(result[v], *end, nearness);
      }
    }
  }
  return result;
}

std::vector<Share> largestFirst(std::vector<Share> shares) {
  std::ranges::stable_sort(shares, std::ranges::greater{}, &Share::weight);
  return shares;
}

/// A vertex's list in the making.
class Candidates {
 public:
  void add(int binding) {
    if (list_.size() < kMostCandidates && std::ranges::find(list_, binding) == list_.end()) list_.push_back(binding);
  }
  void addAll(const std::vector<Share>& shares, std::size_t most) {
    for (std::size_t i = 0; i < std::min(most, shares.size()); ++i) add(shares[i].binding);
  }
  /// Bones by their steps from one bone, until the list is full.
  void addNearest(const Skeleton& skeleton, int from, const std::vector<bool>& wanted) {
    std::vector<int> reached{from};
    std::vector<bool> seen(skeleton.bones.size(), false);
    at(seen, from) = true;
    for (std::size_t i = 0; i < reached.size() && list_.size() < kMostCandidates; ++i) {
      const Bone& bone = at(skeleton.bones, reached[i]);
      if (at(wanted, reached[i])) add(reached[i]);
      const auto reach = [&](int next) {
        if (next < 0 || at(seen, next)) return;
        at(seen, next) = true;
        reached.push_back(next);
      };
      reach(bone.parent);
      for (const int child : bone.children) reach(child);
    }
  }
  std::vector<int> take() && { return std::move(list_); }

 private:
  std::vector<int> list_;
};

constexpr std::size_t kMostMuscleBones = 4;

}  // namespace

Result<std::vector<std::vector<int>>> weightCandidates(const Character& character, const Rig& rig,
                                                       const Refinement& refinement,
                                                       const std::vector<std::vector<Share>>& own) {
  const Result<Attachment> attachment = attach(rig, character);
  if (!attachment) return attachment.error();
  const ControlMesh& mesh = character.mesh;
  const auto ring = interpolatedWeights(following(mesh, ringShares(mesh)), refinement);
  const auto muscles =
      interpolatedWeights(following(mesh, muscleShares(character, rig, attachment.value())), refinement);
  const std::vector<bool> carriesSkin = bonesWithSkin(character);
  std::vector<std::vector<int>> result;
  result.reserve(own.size());
  for (std::size_t v = 0; v < own.size(); ++v) {
    Candidates candidates;
    const std::vector<Share> mine = largestFirst(own[v]);
    candidates.addAll(mine, kMostCandidates);
    candidates.addAll(largestFirst(muscles[v]), kMostMuscleBones);
    candidates.addAll(largestFirst(ring[v]), kMostCandidates);
    candidates.addNearest(character.skeleton, at(character.skeleton.bindings, mine.front().binding).bone, carriesSkin);
    result.push_back(std::move(candidates).take());
  }
  return result;
}

}  // namespace sinew::exporting
