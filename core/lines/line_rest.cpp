// core/lines/line_rest.cpp: anchors found, the frame of the bind pose laid.
#include "core/lines/line_rest.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/lines/contraction.h"
#include "core/lines/line_formulas.h"
#include "core/skeleton/bone_segments.h"

namespace sinew {
namespace {

glm::dvec3 nearestSkin(const ControlMesh& mesh, const glm::dvec3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  glm::dvec3 result = point;
  for (const glm::vec3& position : mesh.positions) {
    const double distance = glm::distance(glm::dvec3(position), point);
    if (distance >= nearest) continue;
    nearest = distance;
    result = glm::dvec3(position);
  }
  return result;
}

glm::dvec3 madeSquare(const glm::dvec3& v, const glm::dvec3& unit) { return v - glm::dot(v, unit) * unit; }

/// Any direction across another; the same for the same.
glm::dvec3 across(const glm::dvec3& unit) {
  const glm::dvec3 axis = std::abs(unit.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
  return glm::normalize(madeSquare(axis, unit));
}

void layFrame(LineRest& rest, const Character& character) {
  const double least = static_cast<double>(kShortestLine * character.height);
  const glm::dvec3 middle = 0.5 * (rest.origin.inBind + rest.insertion.inBind);
  const Bone& origin = at(character.skeleton.bones, rest.origin.bone);
  const glm::dvec3 bone(bindSegment(origin).nearest(glm::vec3(middle)));
  glm::dvec3 height = madeSquare(middle - bone, rest.direction);
  if (glm::length(height) < least) height = madeSquare(nearestSkin(character.mesh, middle) - middle, rest.direction);
  const glm::dvec3 z = glm::length(height) < least ? across(rest.direction) : glm::normalize(height);
  rest.frame = {glm::cross(rest.direction, z), rest.direction, z};
  rest.height = std::max(0.0, glm::dot(middle - bone, z));
}

}  // namespace

std::optional<BonePoint> foundPoint(const LineAnchor& anchor, const Skeleton& skeleton) {
  const std::optional<int> bone = skeleton.findBone(anchor.bone);
  if (!bone) return std::nullopt;
  const glm::dvec3 point(anchor.point);
  return BonePoint{*bone, point,
                   glm::dvec3(glm::dmat4(at(skeleton.bones, *bone).bindInWorld) * glm::dvec4(point, 1.0))};
}

glm::dvec3 posedPoint(const BonePoint& point, const Pose& pose) {
  const glm::mat4& bone = at(pose.boneInWorld, point.bone);
  return glm::dmat3(glm::mat3(bone)) * point.inBone + glm::dvec3(bone[3]);
}

glm::dvec3 viaShift(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& via, double tendon,
                    double belly) {
  namespace lanes = HWY_NAMESPACE;
  constexpr lanes::OneDouble kOne;
  const auto lane = [&](double value) { return lanes::hn::Set(kOne, value); };
  const auto shift = lanes::viaShiftOf(kOne, lanes::all(kOne, origin), lanes::all(kOne, direction),
                                       lanes::all(kOne, via), lane(tendon), lane(belly));
  return {lanes::hn::GetLane(shift.x), lanes::hn::GetLane(shift.y), lanes::hn::GetLane(shift.z)};
}

Result<LineRest> lineRest(const MuscleLine& line, const Character& character) {
  const std::string subject = "muscle line \"" + line.name + '"';
  LineRest rest;
  const auto take = [&](const LineAnchor& anchor, const char* what, BonePoint& point) -> Result<void> {
    const std::optional<BonePoint> found = foundPoint(anchor, character.skeleton);
    if (!found) return about(subject, errorAt("", "this character has no bone \"" + anchor.bone + '"', what));
    point = *found;
    return {};
  };
  if (auto origin = take(line.origin, "origin", rest.origin); !origin) return origin.error();
  if (auto insertion = take(line.insertion, "insertion", rest.insertion); !insertion) return insertion.error();
  if (line.via) {
    if (auto via = take(*line.via, "via point", rest.via.emplace()); !via) return via.error();
  }
  const double straight = glm::distance(rest.origin.inBind, rest.insertion.inBind);
  if (!(straight >= static_cast<double>(kShortestLine * character.height))) {
    return errorAt("", "its ends are at the same place in the bind pose", subject);
  }
  rest.length = straight;
  if (rest.via) {
    rest.length =
        glm::distance(rest.origin.inBind, rest.via->inBind) + glm::distance(rest.via->inBind, rest.insertion.inBind);
  }
  rest.direction = (rest.insertion.inBind - rest.origin.inBind) / straight;
  layFrame(rest, character);
  settle(rest, line.settings);
  return rest;
}

void settle(LineRest& rest, const LineSettings& settings) {
  rest.settings = settings;
  rest.bellyStretch = bellyStretch(1.0 / static_cast<double>(settings.rest), settings);
  rest.girth = girthRest(settings);
  rest.depth = static_cast<double>(settings.pivot) * rest.height;
  const double tendon = static_cast<double>(settings.tendons.x * settings.rest) * rest.length;
  rest.start = rest.origin.inBind + tendon * rest.direction - rest.depth * rest.frame[2];
  if (!rest.via) return;
  const double restLength = static_cast<double>(settings.rest) * rest.length;
  const glm::dvec2 tendons(settings.tendons);
  rest.viaShift = viaShift(rest.origin.inBind, rest.direction, rest.via->inBind, tendons.x * restLength,
                           rest.bellyStretch * (1.0 - tendons.x - tendons.y) * restLength);
}

std::vector<std::optional<LineRest>> lineRests(const Rig& rig, const Character& character) {
  std::vector<std::optional<LineRest>> rests;
  rests.reserve(rig.lines.size());
  for (const MuscleLine& line : rig.lines) {
    Result<LineRest> rest = lineRest(line, character);
    rests.push_back(rest ? std::optional(std::move(rest).value()) : std::nullopt);
  }
  return rests;
}

}  // namespace sinew
