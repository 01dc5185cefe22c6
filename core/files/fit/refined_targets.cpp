// core/files/fit/refined_targets.cpp: one surface a target, and the weights that clip and rig give together.
#include "core/files/fit/refined_targets.h"

#include <algorithm>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/rig/morphs.h"
#include "core/rig/posed_rig.h"
#include "sinew/character/character_pose.h"

namespace sinew::exporting {
namespace {

constexpr float kRefinedTargetsSameNormal = 1e-4f;  ///< Turns that are smaller are rounding.

RefinedTarget differenceOf(const Surface& with, const Surface& without) {
  RefinedTarget target;
  for (std::size_t v = 0; v < without.positions.size(); ++v) {
    if (with.positions[v] == without.positions[v]) continue;
    target.vertices.push_back(static_cast<int>(v));
    target.deltas.push_back(with.positions[v] - without.positions[v]);
  }
  for (std::size_t d = 0; d < without.refinement->drawVertex.size(); ++d) {
    const glm::vec3 turn = shadingNormal(with, d) - shadingNormal(without, d);
    if (glm::length(turn) <= kRefinedTargetsSameNormal) continue;
    target.drawn.push_back(static_cast<int>(d));
    target.normals.push_back(turn);
  }
  return target;
}

/// [targets] Whether the rig adds to a target of the same node.
std::vector<bool> keyedTargets(const Character& character, const Rig& rig) {
  const auto adds = [&](const std::string& name) {
    const int index = findMorph(rig, name);
    return index >= 0 && !isIdle(at(rig.morphs, index));
  };
  std::set<int> nodes;
  for (const MorphTarget& target : character.morphTargets) {
    if (adds(target.name)) nodes.insert(target.node);
  }
  for (const MorphSet& set : character.morphSets) {
    for (const MorphSet::Share& each : set.shares) {
      if (adds(set.name)) nodes.insert(at(character.morphTargets, each.target).node);
    }
  }
  std::vector<bool> keyed;
  for (const MorphTarget& target : character.morphTargets) keyed.push_back(nodes.contains(target.node));
  return keyed;
}

}  // namespace

Pose withoutMorphs(const Character& character, Pose pose) {
  pose.morphWeights.assign(character.morphTargets.size(), 0.0f);
  return pose;
}

std::vector<RefinedTarget> refinedTargets(const Character& character, LiveSurfaces& surfaces, const Surface& bind) {
  std::vector<RefinedTarget> targets;
  const auto poseOf = [&](std::size_t k) {
    Pose pose = withoutMorphs(character, bindPose(character.skeleton));
    pose.morphWeights[k] = 1.0f;
    return pose;
  };
  surfaces.forEach(character.morphTargets.size(), poseOf,
                   [&](std::size_t, const Pose&, const Surface& live) { targets.push_back(differenceOf(live, bind)); });
  return targets;
}

std::vector<RefinedTarget> originalTargets(const Character& character) {
  std::vector<RefinedTarget> targets;
  for (const MorphTarget& target : character.morphTargets) targets.push_back({target.vertices, target.deltas, {}, {}});
  return targets;
}

void setMorphKeys(const Character& character, const Rig& rig, std::span<const ExportPose> poses, PlayedMorphs& out) {
  const RigPoser poser(rig, character);
  out.rest = poser.pose(bindPose(character.skeleton)).morphWeights;
  out.keyed = keyedTargets(character, rig);
  int clip = -1;
  for (const ExportPose& pose : poses) {
    const AnimationClip& of = at(character.clips, pose.clip);
    if (std::exchange(clip, pose.clip) != pose.clip) out.clips.push_back({of.name, {}, {}});
    const std::vector<float> weights = poser.pose(samplePose(character, of, pose.time)).morphWeights;
    out.clips.back().times.push_back(pose.time);
    out.clips.back().weights.insert(out.clips.back().weights.end(), weights.begin(), weights.end());
  }
}

}  // namespace sinew::exporting
