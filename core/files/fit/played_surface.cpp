// core/files/fit/played_surface.cpp: morph targets, the error meter, and playing: keys, targets, linear blend skinning.

#include "core/files/fit/played_surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/rig/posed_rig.h"
#include "core/rig/rig_edit.h"
#include "sinew/character/character_pose.h"

namespace sinew::exporting {

// Morph targets.

namespace {

constexpr float kRefinedTargetsSameNormal = 1e-4f;  ///< Smaller changes are rounding.

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

/// [targets] whether the rig adds to a target of the same node.
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

// The error meter: classes are the leading bits of floats.

constexpr unsigned kDroppedBits = 13;

void ErrorMeter::add(double distance, int vertex) {
  // NaN has no class.
  const double percent = std::isfinite(distance) ? distance * scale_ : std::numeric_limits<double>::infinity();
  squares_ += percent * percent;
  if (percent > largest_ || farthest_.vertex < 0) {
    largest_ = percent;
    farthestClip_ = clip_;
    farthest_.time = time_;
    farthest_.vertex = vertex;
  }
  ++count_;
  const std::uint32_t slot = std::bit_cast<std::uint32_t>(static_cast<float>(percent)) >> kDroppedBits;
  std::vector<std::uint64_t>& octave = counts_[slot / kClassesOfOctave];
  if (octave.empty()) octave.resize(kClassesOfOctave, 0);
  ++octave[slot % kClassesOfOctave];
}

float ErrorMeter::upperBoundOfAllBut(std::uint64_t above) const {
  for (std::size_t octave = kOctaves; octave-- > 0;) {
    const std::vector<std::uint64_t>& counts = counts_[octave];
    for (std::size_t place = counts.size(); place-- > 0; above -= counts[place]) {
      if (counts[place] <= above) continue;
      const std::size_t slot = octave * kClassesOfOctave + place;
      return std::bit_cast<float>(static_cast<std::uint32_t>(slot + 1) << kDroppedBits);
    }
  }
  return 0.0f;
}

ErrorFigures ErrorMeter::figures() const {
  ErrorFigures figures;
  figures.poses = poses_;
  if (count_ == 0) return figures;
  figures.rms = std::sqrt(squares_ / static_cast<double>(count_));
  figures.largest = largest_;
  figures.farthest = farthest_;
  const float upper = upperBoundOfAllBut(count_ / 1000);
  figures.percentile999 = std::min(static_cast<double>(upper), largest_);
  return figures;
}

// Playing.

namespace {

constexpr std::size_t kLeastPlayedRange = 1024;  ///< Vertices per thread, at least.
constexpr double kBetweenPerKey = 47.0 / 30.0;

/// Two keys and the position between them.
struct Span {
  std::size_t from = 0;
  std::size_t to = 0;
  double part = 0.0;
};

/// @param times  rising, at least one
Span spanAt(const std::vector<float>& times, float time) {
  const auto next = std::ranges::upper_bound(times, time);
  if (next == times.begin()) return {};
  const auto to = static_cast<std::size_t>(next - times.begin());
  if (next == times.end()) return {to - 1, to - 1, 0.0};
  const double from = static_cast<double>(times[to - 1]);
  return {to - 1, to, (static_cast<double>(time) - from) / (static_cast<double>(*next) - from)};
}

Trs mixed(const Trs& a, const Trs& b, double part) {
  return {glm::mix(a.translation, b.translation, part), glm::slerp(a.rotation, b.rotation, part),
          glm::mix(a.scale, b.scale, part)};
}

}  // namespace

PlayedSurface::PlayedSurface(std::shared_ptr<const Character> character, std::vector<glm::vec3> restPositions,
                             std::vector<FourWeights> weights, std::vector<HelperJoint> joints,
                             std::vector<HelperClip> clips)
    : character_(std::move(character)),
      weights_(std::move(weights)),
      joints_(std::move(joints)),
      clips_(std::move(clips)) {
  rest = std::move(restPositions);
}

std::vector<glm::dmat4> PlayedSurface::matricesAt(const Pose& pose, const std::string& clip, float time) const {
  std::vector<glm::dmat4> matrices;
  bindingMatrices(character_->skeleton, pose, matrices);
  const auto keyed = std::ranges::find(clips_, clip, &HelperClip::clip);
  const bool hasKeys = keyed != clips_.end() && !keyed->times.empty();
  const Span span = hasKeys ? spanAt(keyed->times, time) : Span{};
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Trs local =
        hasKeys ? mixed(keyed->locals[j][span.from], keyed->locals[j][span.to], span.part) : joints_[j].rest;
    matrices.push_back(helperMatrix(joints_[j], pose, local));
  }
  return matrices;
}

std::vector<float> PlayedSurface::morphWeightsAt(const Pose& pose, const std::string& clip, float time) const {
  std::vector<float> weights = morphWeightsOr(*character_, pose.morphWeights);
  const auto keys = std::ranges::find(morphs.clips, clip, &MorphKeys::clip);
  const bool plays = keys != morphs.clips.end();
  const Span span = plays ? spanAt(keys->times, time) : Span{};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (!morphs.keyed[k]) continue;
    const auto keyAt = [&](std::size_t key) { return static_cast<double>(keys->weights[key * weights.size() + k]); };
    weights[k] = plays ? static_cast<float>(glm::mix(keyAt(span.from), keyAt(span.to), span.part)) : morphs.rest[k];
  }
  return weights;
}

std::vector<glm::vec3> PlayedSurface::morphedRest(const Pose& pose, const std::string& clip, float time) const {
  std::vector<glm::vec3> moved = rest;
  if (morphs.targets.empty()) return moved;
  const std::vector<float> weights = morphWeightsAt(pose, clip, time);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const RefinedTarget& target = morphs.targets[k];
    for (std::size_t i = 0; i < target.vertices.size() && weights[k] != 0.0f; ++i) {
      at(moved, target.vertices[i]) += weights[k] * target.deltas[i];
    }
  }
  return moved;
}

void PlayedSurface::place(const Pose& pose, const std::string& clip, float time, std::vector<glm::vec3>& out) const {
  const std::vector<glm::dmat4> matrices = matricesAt(pose, clip, time);
  const std::size_t count = targets.clip == clip && !targets.times.empty() ? targets.deltas.size() : 0;
  std::vector<double> shares(count);
  if (count > 0) {
    const Span span = spanAt(targets.times, time);
    for (std::size_t k = 0; k < count; ++k) {
      shares[k] = glm::mix(static_cast<double>(targets.weights[span.from * count + k]),
                           static_cast<double>(targets.weights[span.to * count + k]), span.part);
    }
  }
  const std::vector<glm::vec3> moved = morphedRest(pose, clip, time);
  out.resize(rest.size());
  forEachIndex(rest.size(), kLeastPlayedRange, [&](std::size_t v) {
    glm::dvec3 point(moved[v]);
    for (std::size_t k = 0; k < count; ++k) point += shares[k] * glm::dvec3(targets.deltas[k][v]);
    out[v] = glm::vec3(skinPoint(matrices, weights_[v], point));
  });
}

const std::string& PlayedSurface::boneOf(int vertex) const {
  const Skeleton& skeleton = character_->skeleton;
  const auto binding = toIndex(at(weights_, vertex).binding[0]);
  const std::size_t own = skeleton.bindings.size();
  return at(skeleton.bones, binding < own ? skeleton.bindings[binding].bone : joints_[binding - own].bone).name;
}

std::vector<float> timesBetween(const AnimationClip& clip, double keysPerSecond) {
  return clipTimes(clip, kBetweenPerKey * keysPerSecond);
}

}  // namespace sinew::exporting
