// core/drivers/driven_numbers.cpp: pose -> channels and lengths -> drivers -> numbers within their ranges.
#include "core/drivers/driven_numbers.h"

#include <algorithm>

#include "core/base/at.h"
#include "core/primitives/shape_numbers.h"

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

void note(Parameter parameter, DrivenChange& change) {
  change.primitives |= ownerOf(parameter) == ParameterOwner::kPrimitive;
  change.lines |= ownerOf(parameter) == ParameterOwner::kLine;
}

bool shapes(Parameter parameter) { return parameter == Parameter::kReach || isShape(parameter); }

}  // namespace

DrivenNumbers::DrivenNumbers(const Rig& rig, const Character& character) {
  if (!isAnimated(rig)) return;
  std::vector<std::optional<LineRest>> rests;
  take(rig.surface.animated, 0, rig, character, rests);
  for (std::size_t i = 0; i < rig.lines.size(); ++i)
    take(rig.lines[i].animated, static_cast<int>(i), rig, character, rests);
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    take(rig.primitives[i].animated, static_cast<int>(i), rig, character, rests);
  }
  lineLanes_ = LineLanes(rests);
}

void DrivenNumbers::take(const std::vector<AnimatedNumber>& animated, int owner, const Rig& rig,
                         const Character& character, std::vector<std::optional<LineRest>>& rests) {
  for (const AnimatedNumber& of : animated) {
    Number number{{of.parameter, owner}, 0.0f, of.keys, {}};
    number.drawn = numberOf(rig, number.ref);
    for (const Driver& driver : of.drivers) {
      std::optional<FoundInput> input = foundInput(driver.input, rig, character);
      if (!input) continue;
      if (input->line >= 0) {
        rests.resize(rig.lines.size());
        at(rests, input->line) = lineRest(at(rig.lines, input->line), character).value();
      }
      number.drivers.push_back({std::move(*input), driver.curve, driver.mode});
    }
    numbers_.push_back(std::move(number));
  }
  if (std::ranges::none_of(animated, [](const AnimatedNumber& of) { return shapes(of.parameter); })) return;
  // A belly lessened in one pose is whole again in the next.
  for (int i = 0; i < kShapeNumbers; ++i) {
    const NumberRef number{shapeParameter(i), owner};
    const bool limited = shapeNumbers()[static_cast<std::size_t>(i)].most != nullptr;
    if (limited && !animationOf(animated, number.parameter))
      numbers_.push_back({number, numberOf(rig, number), {}, {}});
  }
}

void DrivenNumbers::measureLines(const Pose& pose, const Skeleton& skeleton) {
  if (lineLanes_.size() > 0) poseLines(lineLanes_, skeleton, pose, lineScratch_, lines_);
}

float DrivenNumbers::valueOf(const Number& number, const Pose& pose, const Skeleton& skeleton) {
  const KeyTrack* track = trackIn(number.keys, pose.clip);
  float value = track == nullptr ? number.drawn : valueAt(track->curve, pose.time);
  for (const Join& driver : number.drivers) {
    const float x = sinew::valueOf(driver.input, skeleton, pose, lines_, inputs_);
    value = joined(value, valueAt(driver.curve, x), driver.mode);
  }
  return legalNumber(number.ref.parameter, value, number.drawn);
}

DrivenChange DrivenNumbers::apply(const Pose& pose, const Skeleton& skeleton, Rig& rig) {
  DrivenChange change;
  measureLines(pose, skeleton);
  inputs_.turnOf.assign(inputs_.turnOf.size(), std::nullopt);
  for (const Number& number : numbers_) {
    float& now = numberIn(rig, number.ref);
    const float value = valueOf(number, pose, skeleton);
    if (value == now) continue;
    now = value;
    note(number.ref.parameter, change);
  }
  // What one number leaves of another's range: a larger reach allows less of a belly.
  for (const Number& number : numbers_) {
    if (!shapes(number.ref.parameter)) continue;
    Primitive& primitive = at(rig.primitives, number.ref.owner);
    primitive.placement.shape = legalShape(primitive.placement.shape, primitive.reach);
  }
  return change;
}

bool isAnimated(const Rig& rig) {
  const auto any = [](const auto& of) { return !of.animated.empty(); };
  return any(rig.surface) || std::ranges::any_of(rig.lines, any) || std::ranges::any_of(rig.primitives, any);
}

Rig drivenRig(const Rig& rig, const Character& character, const Pose& pose) {
  Rig driven = rig;
  DrivenNumbers numbers(rig, character);
  if (!numbers.isEmpty()) numbers.apply(pose, character.skeleton, driven);
  return driven;
}

const Rig& inPose(const Rig& rig, const Character& character, const Pose& pose, Rig& memory) {
  if (!isAnimated(rig)) return rig;
  memory = drivenRig(rig, character, pose);
  return memory;
}

}  // namespace sinew
