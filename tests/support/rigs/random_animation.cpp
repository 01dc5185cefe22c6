// tests/support/rigs/random_animation.cpp: all kinds of inputs, owners and combinations.
#include "tests/support/rigs/random_animation.h"

#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace sinew::test {
namespace {

template <class T>
const T& oneOf(Random& random, const std::vector<T>& items) {
  return items[static_cast<std::size_t>(random.below(static_cast<int>(items.size())))];
}

glm::vec3 anyPoint(Random& random) {
  return {random.uniform(-1.0f, 1.0f), random.uniform(-1.0f, 1.0f), random.uniform(0.1f, 1.0f)};
}

DriverInput anyInput(Random& random, const std::vector<std::string>& bones, const Rig& rig) {
  DriverInput input;
  input.kind = static_cast<DriverInputKind>(random.below(7));
  if (input.kind == DriverInputKind::kLength && rig.lines.empty()) input.kind = DriverInputKind::kTwist;
  if (input.kind == DriverInputKind::kChannel && rig.channels.empty()) input.kind = DriverInputKind::kBend;
  if (random.chance(0.2f)) input.unknownKeys = R"({"later":[1,2]})";
  switch (input.kind) {
    case DriverInputKind::kLength:
      input.line = oneOf(random, rig.lines).name;
      return input;
    case DriverInputKind::kDistance:
      input.from = {oneOf(random, bones), anyPoint(random), {}};
      input.to = {oneOf(random, bones), anyPoint(random) + glm::vec3(0.0f, 3.0f, 0.0f), {}};
      return input;
    case DriverInputKind::kChannel:
      input.channel = oneOf(random, rig.channels).name;
      return input;
    case DriverInputKind::kAxis:
      input.axis = glm::normalize(anyPoint(random));
      break;
    case DriverInputKind::kPose:
      input.rotation = glm::angleAxis(random.uniform(0.0f, 3.0f), glm::normalize(anyPoint(random)));
      input.width = random.uniform(10.0f, 90.0f);
      break;
    default:
      break;
  }
  input.bone = oneOf(random, bones);
  return input;
}

Driver anyDriver(Random& random, const std::vector<std::string>& bones, const Rig& rig) {
  Driver driver;
  driver.input = anyInput(random, bones, rig);
  const bool angle = driver.input.kind <= DriverInputKind::kAxis;
  driver.curve = angle ? anyCurve(random, -120.0f, 240.0f, 5) : anyCurve(random, 0.0f, 1.5f, 5);
  driver.mode = static_cast<DriverMode>(random.below(3));
  return driver;
}

void animate(Random& random, const std::vector<std::string>& bones, const std::vector<std::string>& clips,
             Parameter parameter, const Rig& rig, std::vector<AnimatedNumber>& animated) {
  AnimatedNumber number{parameter, {}, {}, {}};
  if (random.chance(0.6f)) number.keys.push_back({oneOf(random, clips), anyCurve(random, 0.0f, 2.0f, 6), {}});
  if (random.chance(0.4f)) number.keys.push_back({{}, anyCurve(random, 0.0f, 2.0f, 6), {}});
  for (int i = random.below(3); i > 0; --i) number.drivers.push_back(anyDriver(random, bones, rig));
  if (!number.keys.empty() || !number.drivers.empty()) animated.push_back(std::move(number));
}

}  // namespace

Rig animatedLimbRig(const Character& limb, std::uint64_t seed) {
  Rig rig = randomRig(limb, {.primitives = 4, .shapedChance = 0.4f}, seed);
  MuscleLine line;
  line.name = "span";
  line.origin = {"root", {0.1f, 0.2f, 0.1f}, {}};
  line.insertion = {"end", {0.1f, 0.1f, 0.1f}, {}};
  rig.lines.push_back(line);
  for (const std::size_t i : {0u, 1u}) rig.primitives[i].line = line.name;
  Random random(seed);
  addAnimation(random, {"root", "middle", "end"}, {limb.clips.front().name}, rig);
  return rig;
}

Curve anyCurve(Random& random, float least, float range, int most) {
  Curve curve;
  curve.kind = static_cast<CurveKind>(random.below(3));
  const int count = 1 + random.below(most);
  float x = least;
  for (int i = 0; i < count; ++i) {
    x += random.uniform(0.01f, range / static_cast<float>(count));
    curve.points.push_back({x, random.uniform(-0.5f, 1.5f)});
  }
  return curve;
}

void addAnimation(Random& random, const std::vector<std::string>& bones, const std::vector<std::string>& clips,
                  Rig& rig) {
  for (int i = random.below(3); i > 0; --i) {
    const std::string name = "effort " + std::to_string(i);
    rig.channels.push_back({name, {{}, anyCurve(random, 0.0f, 2.0f, 6), {}}});
    if (random.chance(0.5f))
      rig.channels.push_back({name, {oneOf(random, clips), anyCurve(random, 0.0f, 2.0f, 6), {}}});
  }
  const auto some = [&](Parameter from, Parameter to, std::vector<AnimatedNumber>& animated) {
    for (int p = static_cast<int>(from); p <= static_cast<int>(to); ++p) {
      if (random.chance(0.25f)) animate(random, bones, clips, static_cast<Parameter>(p), rig, animated);
    }
  };
  some(Parameter::kSkinBlend, Parameter::kGrooves, rig.surface.animated);
  for (MuscleLine& line : rig.lines) some(Parameter::kActivation, Parameter::kFlexWidth, line.animated);
  for (Primitive& primitive : rig.primitives)
    some(Parameter::kAmount, shapeParameter(kShapeNumbers - 1), primitive.animated);
  for (Link& link : rig.links) {
    if (random.chance(0.5f)) animate(random, bones, clips, Parameter::kLinkAmount, rig, link.animated);
  }
}

}  // namespace sinew::test
