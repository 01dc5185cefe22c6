// core/rig/animated_twins.cpp: inputs through the plane, values through the image's own axes.
#include "core/rig/animated_twins.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/gtc/quaternion.hpp>

#include "core/character/pose_override.h"
#include "core/geometry/at.h"
#include "core/rig/line_twins.h"

namespace sinew {
namespace {

/// value there = factor * value here + offset.
struct NumberMap {
  Parameter parameter = Parameter::kAmount;
  float factor = 1.0f;
  float offset = 0.0f;
};

constexpr float kStray = 1e-3f;  // How much of a step along one axis may appear on another.

bool mirrorBone(const MirrorPlan& plan, std::string& bone) {
  Result<std::string> twin = twinBone(plan, bone);
  if (!twin) return false;
  bone = std::move(twin).value();
  return true;
}

bool mirrorAnchor(const MirrorPlan& plan, LineAnchor& anchor) {
  Result<LineAnchor> image = mirroredAnchor(plan, anchor);
  if (!image) return false;
  anchor = std::move(image).value();
  return true;
}

glm::quat mirroredTurn(const MirrorPlan& plan, const glm::quat& turn, int bone) {
  const int twin = at(plan.twinOf, bone);
  return sinew::mirroredTurn(turn, at(plan.skeleton.bones, bone), at(plan.skeleton.bones, twin),
                             glm::vec3(plan.plane.normal));
}

/// The curve of -x.
void reverse(Curve& curve) {
  std::vector<glm::vec2>& points = curve.points;
  for (glm::vec2& point : points) point.x = -point.x;
  std::ranges::reverse(points);
  if (curve.kind != CurveKind::kStep) return;
  // A step's value holds after its point; now it must hold before it.
  for (std::size_t i = points.size() - 1; i > 0; --i) points[i].x = points[i - 1].x;
  points.front().x -= std::max(1.0f, 1e-3f * std::abs(points.front().x));
}

float stepFor(const Primitive& primitive, Parameter parameter) {
  const glm::vec3& radii = primitive.placement.radii;
  const float size = std::min({radii.x, radii.y, radii.z});
  return isLength(parameter) ? 0.125f * size : 0.03125f;
}

constexpr int kFirst = static_cast<int>(Parameter::kCenterX);
constexpr int kLast = static_cast<int>(shapeParameter(kShapeNumbers - 1));

/// What a number of a primitive is on its image, found by taking a step: exactly one number of the image may move.
std::optional<NumberMap> mapOf(const MirrorPlan& plan, const Primitive& primitive, Parameter parameter) {
  if (parameter == Parameter::kAmount || parameter == Parameter::kReach) return NumberMap{parameter, 1.0f, 0.0f};
  const std::optional<int> bone = plan.skeleton.findBone(primitive.bone);
  if (!bone || at(plan.twinOf, *bone) < 0) return std::nullopt;
  const AffineMap& map = *at(plan.mirrors, *bone);
  Primitive before = primitive;
  before.placement = imageOf(primitive.placement, map);
  Primitive stepped = primitive;
  const float step = stepFor(primitive, parameter);
  *numberIn(stepped, parameter) += step;
  stepped.placement = imageOf(stepped.placement, map);

  std::optional<NumberMap> found;
  float most = 0.0f;
  for (int i = kFirst; i <= kLast; ++i) {
    const auto other = static_cast<Parameter>(i);
    const float moved = numberOf(stepped, other) - numberOf(before, other);
    if (std::abs(moved) <= most) continue;
    most = std::abs(moved);
    found = NumberMap{other, moved / step, 0.0f};
  }
  if (!found) return std::nullopt;
  for (int i = kFirst; i <= kLast; ++i) {
    const auto other = static_cast<Parameter>(i);
    if (other == found->parameter) continue;
    if (std::abs(numberOf(stepped, other) - numberOf(before, other)) > kStray * most) return std::nullopt;
  }
  // What a float's step says of 1 and -1 is not exact.
  const float rounded = std::round(found->factor);
  if (std::abs(found->factor - rounded) < kStray) found->factor = rounded;
  found->offset = numberOf(before, found->parameter) - found->factor * numberOf(primitive, parameter);
  if (std::abs(found->offset) < kStray * step) found->offset = 0.0f;
  return found;
}

void mapValues(Curve& curve, float factor, float offset) {
  for (glm::vec2& point : curve.points) point.y = factor * point.y + offset;
}

/// False where a product has no counterpart.
bool mapDriver(const NumberMap& map, Driver& driver) {
  switch (driver.mode) {
    case DriverMode::kAdd:
      mapValues(driver.curve, map.factor, 0.0f);
      return true;
    case DriverMode::kReplace:
      mapValues(driver.curve, map.factor, map.offset);
      return true;
    case DriverMode::kMultiply:
      break;
  }
  return map.offset == 0.0f;
}

std::optional<AnimatedNumber> mirrored(const MirrorPlan& plan, const AnimatedNumber& number, const NumberMap& map) {
  AnimatedNumber image = number;
  image.parameter = map.parameter;
  for (KeyTrack& track : image.keys) mapValues(track.curve, map.factor, map.offset);
  image.drivers.clear();
  for (const Driver& driver : number.drivers) {
    std::optional<Driver> twin = mirroredDriver(plan, driver);
    if (twin && mapDriver(map, *twin)) image.drivers.push_back(std::move(*twin));
  }
  if (image.keys.empty() && image.drivers.empty()) return std::nullopt;
  return image;
}

}  // namespace

std::optional<Driver> mirroredDriver(const MirrorPlan& plan, const Driver& driver) {
  Driver image = driver;
  DriverInput& input = image.input;
  switch (input.kind) {
    case DriverInputKind::kLength:
    case DriverInputKind::kChannel:
      return image;
    case DriverInputKind::kDistance:
      return mirrorAnchor(plan, input.from) && mirrorAnchor(plan, input.to) ? std::optional(image) : std::nullopt;
    default:
      break;
  }
  const std::optional<int> bone = plan.skeleton.findBone(driver.input.bone);
  if (!mirrorBone(plan, input.bone)) return std::nullopt;
  if (input.kind == DriverInputKind::kTwist) reverse(image.curve);
  if (input.kind == DriverInputKind::kPose) input.rotation = mirroredTurn(plan, driver.input.rotation, *bone);
  if (input.kind == DriverInputKind::kAxis) {
    // A half turn about the axis is one about its image.
    const glm::vec3& axis = driver.input.axis;
    const glm::quat turn = mirroredTurn(plan, glm::quat(0.0f, axis.x, axis.y, axis.z), *bone);
    input.axis = glm::vec3(turn.x, turn.y, turn.z);
  }
  return image;
}

std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const Primitive& primitive) {
  std::vector<AnimatedNumber> images;
  for (const AnimatedNumber& number : primitive.animated) {
    const std::optional<NumberMap> map = mapOf(plan, primitive, number.parameter);
    if (!map) continue;
    if (std::optional<AnimatedNumber> image = mirrored(plan, number, *map)) images.push_back(std::move(*image));
  }
  return images;
}

std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const MuscleLine& line) {
  std::vector<AnimatedNumber> images;
  for (const AnimatedNumber& number : line.animated) {
    const NumberMap same{number.parameter, 1.0f, 0.0f};
    if (std::optional<AnimatedNumber> image = mirrored(plan, number, same)) images.push_back(std::move(*image));
  }
  return images;
}

void readTwinLines(const Rig& rig, std::vector<AnimatedNumber>& animated) {
  for (AnimatedNumber& number : animated) {
    for (Driver& driver : number.drivers) {
      if (driver.input.kind == DriverInputKind::kLength) driver.input.line = twinLineName(rig, driver.input.line);
    }
  }
}

}  // namespace sinew
