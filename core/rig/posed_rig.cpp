// core/rig/posed_rig.cpp: numbers first, then the lines they set, then the muscles on bones and lines.
#include "core/rig/posed_rig.h"

#include <string_view>
#include <unordered_map>

#include "core/character/morphing.h"
#include "core/geometry/at.h"

namespace sinew {

RigPoser::RigPoser(const Rig& rig, const Character& character)
    : skeleton_(&character.skeleton),
      drawn_(drawnNumbers(rig)),
      driven_(rig, character),
      drivesMuscles_(driven_.changes(ParameterOwner::kPrimitive)),
      drivesLines_(driven_.changes(ParameterOwner::kLine)),
      rests_(lineRests(rig, character)),
      morphWeights_(morphWeightsOr(character, {})) {
  const auto& targets = character.morphTargets;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    if (const int morph = findMorph(rig, targets[k].name); morph >= 0) {
      morphShares_.push_back({static_cast<int>(k), morph, 1.0f});
    }
  }
  for (const MorphSet& set : character.morphSets) {
    const int morph = findMorph(rig, set.name);
    for (const MorphSet::Share& each : set.shares) {
      if (morph >= 0) morphShares_.push_back({each.target, morph, each.share});
    }
  }
  std::unordered_map<std::string_view, int> lineOf;
  for (std::size_t i = 0; i < rig.lines.size(); ++i) lineOf.emplace(rig.lines[i].name, static_cast<int>(i));
  rides_.reserve(rig.primitives.size());
  for (const Primitive& primitive : rig.primitives) {
    const auto line = primitive.line.empty() ? lineOf.end() : lineOf.find(primitive.line);
    rides_.push_back({skeleton_->findBone(primitive.bone).value_or(-1), line == lineOf.end() ? -1 : line->second});
  }
}

void RigPoser::poseLines(const Pose& pose, PosedRig& out) const {
  out.rests = rests_;
  for (std::size_t i = 0; drivesLines_ && i < rests_.size(); ++i) {
    if (out.rests[i]) settle(*out.rests[i], out.numbers.lines[i]);
  }
  sinew::poseLines(out.rests, *skeleton_, pose, out.posing, out.lines);
}

PosedMuscle RigPoser::posedMuscle(const Ride& ride, const Placement& placement, const Pose& pose,
                                  const PosedRig& in) const {
  PosedMuscle muscle;
  muscle.line = ride.line;
  if (ride.bone < 0) return muscle;
  muscle.usable = ride.line < 0 || at(in.lines, ride.line).usable;
  muscle.carrier = carrierInWorld(ride.bone, ride.line, *skeleton_, pose, in.lines);
  muscle.body = {muscle.carrier, placement};
  if (ride.line < 0 || !at(in.rests, ride.line) || at(in.lines, ride.line).aside == glm::vec3(0.0f)) return muscle;
  const ViaBend bend = viaBend(*at(in.rests, ride.line), placement, at(skeleton_->bones, ride.bone).bindInWorld);
  muscle.isBent = true;
  muscle.body = bentMuscle(bend, muscle.carrier, at(in.lines, ride.line).aside);
  return muscle;
}

void RigPoser::pose(const Pose& pose, PosedRig& out) const {
  out.numbers = drawn_;
  if (!driven_.isEmpty()) driven_.apply(pose, *skeleton_, out.drivers, out.numbers);
  out.morphWeights = pose.morphWeights.empty() ? morphWeights_ : pose.morphWeights;
  for (const auto& [target, morph, share] : morphShares_) {
    at(out.morphWeights, target) += share * at(out.numbers.morphs, morph);
  }
  poseLines(pose, out);
  out.muscles.resize(rides_.size());
  for (std::size_t i = 0; i < rides_.size(); ++i) {
    out.muscles[i] = posedMuscle(rides_[i], out.numbers.primitives[i].placement, pose, out);
  }
}

PosedRig RigPoser::pose(const Pose& pose) const {
  PosedRig posed;
  this->pose(pose, posed);
  return posed;
}

}  // namespace sinew
