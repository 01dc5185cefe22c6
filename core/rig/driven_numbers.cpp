// core/rig/driven_numbers.cpp: pose -> channels and lengths -> drivers -> numbers within their ranges.
#include "core/rig/driven_numbers.h"

#include <algorithm>

#include "core/geometry/at.h"
#include "core/geometry/shape_numbers.h"

namespace sinew {
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
  // What one number leaves of another's range: a larger reach allows less of a belly.
  for (const Number& number : numbers_) {
    if (!shapes(number.ref.parameter)) continue;
    MuscleNumbers& muscle = at(numbers.primitives, number.ref.owner);
    muscle.placement.shape = legalShape(muscle.placement.shape, muscle.reach);
  }
}

}  // namespace sinew
