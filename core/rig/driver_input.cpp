// core/rig/driver_input.cpp: resolves inputs, measures them in poses, and applies keys and drivers to numbers.
#include "core/rig/driver_input.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "core/character/pose_override.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

glm::dvec3 directionIn(const glm::mat4& boneInWorld, const Bone& bone) {
  return glm::dmat3(glm::mat3(boneInWorld)) * glm::dvec3(bone.tip);
}

/// Accurate near 0 and near a half turn, unlike acos.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

float bendOf(const Skeleton& skeleton, const Pose& pose, int bone) {
  const Bone& own = at(skeleton.bones, bone);
  const glm::dvec3 inBind = directionIn(own.bindInWorld, own);
  const glm::dvec3 now = directionIn(at(pose.boneInWorld, bone), own);
  if (own.parent < 0) return static_cast<float>(glm::degrees(angleBetween(inBind, now)));
  const Bone& parent = at(skeleton.bones, own.parent);
  const double bound = angleBetween(directionIn(parent.bindInWorld, parent), inBind);
  const double bent = angleBetween(directionIn(at(pose.boneInWorld, own.parent), parent), now);
  return static_cast<float>(glm::degrees(bent - bound));
}

glm::vec3 boneDirection(const Bone& bone) {
  const glm::vec3 inFrame = glm::transpose(turnFrame(bone.bindInWorld)) * glm::mat3(bone.bindInWorld) * bone.tip;
  return normalizeOr(inFrame, glm::vec3(0.0f, 1.0f, 0.0f));
}

float turnAbout(const glm::quat& turn, const glm::vec3& axis) {
  const double along = glm::dot(glm::dvec3(turn.x, turn.y, turn.z), glm::dvec3(axis));
  const auto w = static_cast<double>(turn.w);
  // A quaternion and its negative are the same turn.
  return static_cast<float>(glm::degrees(2.0 * (w < 0.0 ? std::atan2(-along, -w) : std::atan2(along, w))));
}

float nearness(const glm::quat& turn, const glm::quat& wanted, float width) {
  const glm::dquat between = glm::conjugate(glm::dquat(wanted)) * glm::dquat(turn);
  const double angle =
      glm::degrees(2.0 * std::atan2(glm::length(glm::dvec3(between.x, between.y, between.z)), std::abs(between.w)));
  const double share = angle / static_cast<double>(width);
  return static_cast<float>(std::exp(-0.5 * share * share));
}

namespace {

bool findPoints(const DriverInput& input, const Character& character, FoundInput& found) {
  const std::optional<BonePoint> from = findPoint(input.from, character.skeleton);
  const std::optional<BonePoint> to = findPoint(input.to, character.skeleton);
  if (!from || !to) return false;
  found.from = *from;
  found.to = *to;
  found.distanceInBind = glm::distance(found.from.inBind, found.to.inBind);
  return found.distanceInBind >= static_cast<double>(kShortestLine * character.height);
}

bool findJoint(const DriverInput& input, const Skeleton& skeleton, FoundInput& found) {
  const std::optional<int> bone = skeleton.findBone(input.bone);
  if (!bone) return false;
  found.bone = *bone;
  found.axis = input.kind == DriverInputKind::kTwist ? boneDirection(at(skeleton.bones, *bone)) : input.axis;
  found.rotation = input.rotation;
  found.width = input.width;
  return true;
}

const glm::quat& turnOf(int bone, const Skeleton& skeleton, const Pose& pose, InputScratch& scratch) {
  scratch.turnOf.resize(skeleton.bones.size());
  std::optional<glm::quat>& turn = at(scratch.turnOf, bone);
  if (!turn) turn = heldTurn(skeleton, pose, bone);
  return *turn;
}

float finiteOr(float value, float otherwise) { return std::isfinite(value) ? value : otherwise; }

}  // namespace

std::optional<FoundInput> foundInput(const DriverInput& input, const Rig& rig, const Character& character) {
  FoundInput found;
  found.kind = input.kind;
  bool usable = true;
  switch (input.kind) {
    case DriverInputKind::kBend:
    case DriverInputKind::kTwist:
    case DriverInputKind::kAxis:
    case DriverInputKind::kPose:
      usable = findJoint(input, character.skeleton, found);
      break;
    case DriverInputKind::kLength:
      found.line = findLine(rig, input.line);
      usable = found.line >= 0 && lineRest(at(rig.lines, found.line), character).ok();
      break;
    case DriverInputKind::kDistance:
      usable = findPoints(input, character, found);
      break;
    case DriverInputKind::kChannel:
      for (const RigChannel& channel : rig.channels) {
        if (channel.name == input.channel) found.tracks.push_back(channel.track);
      }
      break;
  }
  return usable ? std::optional(std::move(found)) : std::nullopt;
}

float valueOf(const FoundInput& input, const Skeleton& skeleton, const Pose& pose, std::span<const PosedLine> lines,
              InputScratch& scratch) {
  switch (input.kind) {
    case DriverInputKind::kBend:
      return finiteOr(bendOf(skeleton, pose, input.bone), 0.0f);
    case DriverInputKind::kTwist:
    case DriverInputKind::kAxis:
      return finiteOr(turnAbout(turnOf(input.bone, skeleton, pose, scratch), input.axis), 0.0f);
    case DriverInputKind::kPose:
      return finiteOr(nearness(turnOf(input.bone, skeleton, pose, scratch), input.rotation, input.width), 0.0f);
    case DriverInputKind::kLength: {
      const PosedLine& line = lines[static_cast<std::size_t>(input.line)];
      return line.usable ? line.stretch : 1.0f;
    }
    case DriverInputKind::kDistance:
      return finiteOr(static_cast<float>(glm::distance(posedPoint(input.from, pose), posedPoint(input.to, pose)) /
                                         input.distanceInBind),
                      1.0f);
    case DriverInputKind::kChannel:
      break;
  }
  const KeyTrack* track = trackIn(input.tracks, pose.clip);
  return track == nullptr ? 0.0f : valueAt(track->curve, pose.time);
}

std::optional<float> inputNow(const DriverInput& input, const Rig& rig, const Character& character, const Pose& pose) {
  const std::optional<FoundInput> found = foundInput(input, rig, character);
  if (!found) return std::nullopt;
  InputScratch scratch;
  std::vector<PosedLine> lines(rig.lines.size());
  if (found->line >= 0) {
    const Result<LineRest> rest = lineRest(at(rig.lines, found->line), character);
    at(lines, found->line) = posedLine(rest.value(), character.skeleton, pose, pose.flexOf(found->line));
  }
  return valueOf(*found, character.skeleton, pose, lines, scratch);
}

namespace {

float joined(float value, float driven, DriverMode mode) {
  switch (mode) {
    case DriverMode::kAdd:
      return value + driven;
    case DriverMode::kMultiply:
      return value * driven;
    case DriverMode::kReplace:
      break;
  }
  return driven;
}

bool shapes(Parameter parameter) { return parameter == Parameter::kReach || isShape(parameter); }

}  // namespace

DrivenNumbers::DrivenNumbers(const Rig& rig, const Character& character) {
  add(rig.surface.animated, 0, rig, character);
  for (std::size_t i = 0; i < rig.lines.size(); ++i) add(rig.lines[i].animated, static_cast<int>(i), rig, character);
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    add(rig.primitives[i].animated, static_cast<int>(i), rig, character);
  }
  for (std::size_t i = 0; i < rig.morphs.size(); ++i) add(rig.morphs[i].animated, static_cast<int>(i), rig, character);
  for (std::size_t i = 0; i < rig.links.size(); ++i) add(rig.links[i].animated, static_cast<int>(i), rig, character);
}

void DrivenNumbers::add(const std::vector<AnimatedNumber>& animated, int owner, const Rig& rig,
                        const Character& character) {
  for (const AnimatedNumber& of : animated) {
    Number number{{of.parameter, owner}, of.keys, {}};
    for (const Driver& driver : of.drivers) {
      std::optional<FoundInput> input = foundInput(driver.input, rig, character);
      if (!input) continue;
      if (input->line >= 0) {
        rests_.resize(rig.lines.size());
        at(rests_, input->line) = lineRest(at(rig.lines, input->line), character).value();
      }
      number.drivers.push_back({std::move(*input), driver.curve, driver.mode});
    }
    numbers_.push_back(std::move(number));
  }
}

bool DrivenNumbers::changes(ParameterOwner owner) const {
  return std::ranges::any_of(numbers_, [owner](const Number& n) { return ownerOf(n.ref.parameter) == owner; });
}

float DrivenNumbers::valueOf(const Number& number, float drawn, const Pose& pose, const Skeleton& skeleton,
                             DriverScratch& scratch) const {
  const KeyTrack* track = trackIn(number.keys, pose.clip);
  float value = track == nullptr ? drawn : valueAt(track->curve, pose.time);
  for (const Join& driver : number.drivers) {
    const float x = sinew::valueOf(driver.input, skeleton, pose, scratch.lines, scratch.inputs);
    value = joined(value, valueAt(driver.curve, x), driver.mode);
  }
  return legalNumber(number.ref.parameter, value, drawn);
}

void DrivenNumbers::apply(const Pose& pose, const Skeleton& skeleton, DriverScratch& scratch,
                          RigNumbers& numbers) const {
  if (!rests_.empty()) poseLines(rests_, skeleton, pose, scratch.posing, scratch.lines);
  scratch.inputs.turnOf.assign(scratch.inputs.turnOf.size(), std::nullopt);
  for (const Number& number : numbers_) {
    float& now = numberIn(numbers, number.ref);
    now = valueOf(number, now, pose, skeleton, scratch);
  }
  // The range of one number may depend on another: a larger reach allows less displacement of the belly.
  for (const Number& number : numbers_) {
    if (!shapes(number.ref.parameter)) continue;
    MuscleNumbers& muscle = at(numbers.primitives, number.ref.owner);
    muscle.placement.shape = legalShape(muscle.placement.shape, muscle.reach);
  }
}

}  // namespace sinew
