// core/rig/posed_rig.cpp: computes numbers first, then lines, then muscles on bones and lines.
#include "core/rig/posed_rig.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/character/skinning.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

// Cosines between a muscle's axis and the line: from kAlong (26 degrees) it bends fully, up to kAcross not at all.
constexpr double kAlong = 0.9;
constexpr double kAcross = 0.7;
// The same for bends in radii: slight ones are hardly visible, and plain ellipsoids are much faster.
constexpr double kSlight = 0.25;
constexpr double kPlain = 0.5;

double smoothstep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Renames the axes of a plain ellipsoid so that y is the one nearest to the line.
Placement alongLine(const Placement& placement, const glm::dmat3& axes, const glm::dvec3& direction) {
  if (!placement.shape.isPlain()) return placement;
  const auto cosine = [&](int i) { return std::abs(glm::dot(glm::normalize(axes[i]), direction)); };
  int along = 1;
  for (const int i : {0, 2}) {
    if (cosine(i) > cosine(along)) along = i;
  }
  const glm::mat3 turned = glm::mat3_cast(placement.rotation);
  Placement same = placement;
  glm::mat3 axesNow;
  for (int i = 0; i < 3; ++i) {
    const int from = (along + i + 2) % 3;
    axesNow[i] = turned[from];
    same.radii[i] = placement.radii[from];
  }
  if (along != 1) same.rotation = glm::normalize(glm::quat_cast(axesNow));
  return same;
}

}  // namespace

ViaBend viaBend(const LineRest& rest, const Placement& placement, const glm::mat4& boneInBind) {
  const glm::dmat3 drawn(glm::mat3(shapeInWorld(placement, 1.0f, boneInBind)));
  ViaBend bend{alongLine(placement, drawn, rest.direction), 0.0f};
  const glm::dvec3 axis(glm::vec3(shapeInWorld(bend.placement, 1.0f, boneInBind)[1]));
  const double radius = glm::length(axis);
  const glm::dvec2 tendons(rest.settings.tendons);
  const double belly =
      rest.bellyStretch * (1.0 - tendons.x - tendons.y) * static_cast<double>(rest.settings.rest) * rest.length;
  if (!(radius > 0.0) || !(belly > 0.0)) return bend;
  const double cosine = std::abs(glm::dot(axis, rest.direction)) / radius;
  // A muscle with a fraction h of the belly's length bends by h^2 of a parabola over the belly.
  const double share = std::min(2.0 * radius * cosine / belly, 1.0);
  bend.share = static_cast<float>(share * share * smoothstep(kAcross, kAlong, cosine));
  return bend;
}

BentMuscle bentMuscle(const ViaBend& bend, const glm::mat4& carrier, const glm::vec3& shift) {
  BentMuscle muscle{carrier, bend.placement};
  const glm::dmat3 axes(glm::mat3(shapeInWorld(bend.placement, 1.0f, carrier)));
  if (!(std::abs(glm::determinant(axes)) > 0.0)) return muscle;
  const glm::dvec3 whole = glm::inverse(axes) * glm::dvec3(bend.share * shift);
  const glm::dvec3 inRadii = smoothstep(kSlight, kPlain, std::hypot(whole.x, whole.z)) * whole;
  const glm::vec2 drawn = bend.placement.shape.bend;
  const glm::vec2 wanted = drawn + glm::vec2(static_cast<float>(inRadii.x), static_cast<float>(inRadii.z));
  if (!std::isfinite(wanted.x) || !std::isfinite(wanted.y)) return muscle;
  const glm::vec2 now = glm::clamp(wanted, -kMostBend, kMostBend);
  const glm::dvec2 bent(now - drawn);
  muscle.placement.shape.bend = now;
  muscle.carrier[3] -= glm::vec4(glm::vec3(bent.x * axes[0] + bent.y * axes[2]), 0.0f);
  return muscle;
}

RigPoser::RigPoser(const Rig& rig, const Character& character)
    : skeleton_(&character.skeleton),
      drawn_(drawnNumbers(rig)),
      driven_(rig, character),
      drivesMuscles_(driven_.changes(ParameterOwner::kPrimitive)),
      drivesLines_(driven_.changes(ParameterOwner::kLine)),
      drivesLinks_(driven_.changes(ParameterOwner::kLink)),
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
