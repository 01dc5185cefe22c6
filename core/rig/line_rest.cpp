// core/rig/line_rest.cpp: finds anchors and sets up frames; girth and activation; curves of tendons and lines.
#include "core/rig/line_rest.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/character/bone_segments.h"
#include "core/geometry/at.h"

namespace sinew {

// Logarithm and exponential function are series, so that the results do not depend on the standard library.

namespace {

constexpr double kLn2High = 0x1.62e42feep-1;  ///< Products with integers below 2^21 are exact.
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;

double clamp(double x, double low, double high) { return std::min(high, std::max(low, x)); }  ///< `low` if x is NaN.

/// ln x to 2e-15 + 1e-13 |ln x| for normal numbers above 0; arbitrary for others.
double naturalLog(double x) {
  constexpr std::uint64_t kRootOfHalf = 0x3FE6A09E667F3BCD;
  constexpr std::uint64_t kOne = 0x3FF0000000000000;
  // x = 2^k m, m from sqrt(1/2) to sqrt(2).
  const std::uint64_t shifted = std::bit_cast<std::uint64_t>(x) + (kOne - kRootOfHalf);
  const double k = static_cast<double>(static_cast<int>(shifted >> 52) - 1023);
  const double m = std::bit_cast<double>((shifted & 0x000FFFFFFFFFFFFF) + kRootOfHalf);
  const double s = (m - 1.0) / (m + 1.0);  // ln m = 2 atanh s.
  const double z = s * s;
  const double z2 = z * z;
  const double low = (1.0 + 1.0 / 3.0 * z) + z2 * (1.0 / 5.0 + 1.0 / 7.0 * z);
  const double high = (1.0 / 9.0 + 1.0 / 11.0 * z) + z2 * (1.0 / 13.0 + 1.0 / 15.0 * z);
  const double series = low + (z2 * z2) * high;
  return k * kLn2High + (k * kLn2Low + (s + s) * series);
}

/// e^x with a relative error of 4e-13; x is clamped to -700..700. Arbitrary if x is not finite.
double exponential(double x) {
  constexpr double kMagic = 0x1.8p52;  // Adding it rounds to an integer in the lowest bits.
  x = clamp(x, -700.0, 700.0);
  const double rounded = x * 0x1.71547652b82fep0 + kMagic;  // x = k ln 2 + r.
  const double k = rounded - kMagic;
  const double r = (x - k * kLn2High) - k * kLn2Low;
  const double r2 = r * r;
  const double r4 = r2 * r2;
  const double low = (1.0 + r) + r2 * (1.0 / 2.0 + 1.0 / 6.0 * r);
  const double middle = (1.0 / 24.0 + 1.0 / 120.0 * r) + r2 * (1.0 / 720.0 + 1.0 / 5040.0 * r);
  const double high = (1.0 / 40320.0 + 1.0 / 362880.0 * r) + 1.0 / 3628800.0 * r2;
  const double series = low + r4 * (middle + r4 * high);
  return series * std::bit_cast<double>((std::bit_cast<std::uint64_t>(rounded) + 1023) << 52);
}

/// ln of a stretch, leveling off at both limits; derivative 1 at rest.
double softenedLog(double stretch, const GirthRest& rest) {
  const double x = naturalLog(stretch);
  const double limit = x < 0.0 ? rest.least : rest.most;
  const double e = exponential(clamp((x + x) / limit, -80.0, 80.0));
  return limit * ((e - 1.0) / (e + 1.0));  // The hyperbolic tangent.
}

}  // namespace

double bellyShare(const LineSettings& settings) {
  return 1.0 - static_cast<double>(settings.tendons.x) - static_cast<double>(settings.tendons.y);
}

double bellyStretch(double stretch, const LineSettings& settings) {
  constexpr double kLeast = 0.1;  // Smallest belly stretch.
  const double belly = bellyShare(settings);
  const double tendons = 1.0 - belly;
  return std::max(kLeast * belly, stretch - tendons) / belly;
}

GirthRest girthRest(const LineSettings& settings) {
  GirthRest rest{static_cast<double>(settings.volume), -std::log(static_cast<double>(settings.limits.x)),
                 std::log(static_cast<double>(settings.limits.y)), 0.0};
  rest.inBind = softenedLog(bellyStretch(1.0 / static_cast<double>(settings.rest), settings), rest);
  return rest;
}

double girth(double bellyStretch, const GirthRest& rest) {
  return exponential(-0.5 * rest.volume * (softenedLog(bellyStretch, rest) - rest.inBind));
}

double activation(double stretch, const LineSettings& settings, double added) {
  const double full = static_cast<double>(settings.full);
  const double shortened = clamp((1.0 - stretch) / (1.0 - full), 0.0, 1.0);
  const double smooth = shortened * shortened * (3.0 - (shortened + shortened));
  const double base = static_cast<double>(settings.base) + added;
  return clamp(base + static_cast<double>(settings.gain) * smooth, 0.0, 1.0);
}

namespace {

constexpr float kBeside = 0.9f;  ///< Least position of anchors along the belly, in half lengths.
constexpr int kPerCurve = 24;    ///< Segments of a drawn curve.

glm::vec3 directionOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : otherwise;
}

/// A Bezier curve that leaves and arrives in the given directions.
std::array<glm::vec3, 4> softCurve(const glm::vec3& from, const glm::vec3& leaves, const glm::vec3& to,
                                   const glm::vec3& arrives) {
  const float third = glm::distance(from, to) / 3.0f;
  return {from, from + third * leaves, to - third * arrives, to};
}

std::optional<Tendon> tendonTo(const glm::mat4& belly, const glm::vec2& bend, float side, const glm::vec3& anchor,
                               const std::optional<glm::vec3>& via) {
  const glm::mat4 inBelly = glm::inverse(belly);
  const auto along = [&](const glm::vec3& point) { return side * (inBelly * glm::vec4(point, 1.0f)).y; };
  const float end = along(anchor);
  if (!(end > kBeside)) return std::nullopt;  // Also if the belly is flat.
  Tendon tendon;
  tendon.side = side;
  // On the belly's axis: (x, z) = bend (1 - y^2).
  const glm::vec2 aside = bend * (1.0f - kTendonStart * kTendonStart), turn = -2.0f * kTendonStart * bend;
  const glm::vec3 from(belly * glm::vec4(aside.x, kTendonStart * side, aside.y, 1.0f));
  const glm::vec3 straight = directionOr(anchor - from, glm::vec3(0.0f, 1.0f, 0.0f));
  const glm::vec3 leaves = directionOr(glm::mat3(belly) * glm::vec3(turn.x, side, turn.y), straight);
  if (via && along(*via) > 1.0f && along(*via) < end) {
    const float before = glm::distance(from, *via);
    tendon.length = before + glm::distance(*via, anchor);
    const float share = before / tendon.length;
    const glm::vec3 arrives = directionOr(anchor - *via, straight);
    tendon.parts = {{softCurve(from, leaves, *via, straight), {0.0f, share}},
                    {softCurve(*via, straight, anchor, arrives), {share, 1.0f}}};
    return tendon;
  }
  tendon.length = glm::distance(from, anchor);
  tendon.parts = {{softCurve(from, leaves, anchor, straight), {0.0f, 1.0f}}};
  return tendon;
}

void addCurve(const std::array<glm::vec3, 4>& curve, std::vector<glm::vec3>& points) {
  for (int i = 1; i <= kPerCurve; ++i) {
    const float t = static_cast<float>(i) / kPerCurve, s = 1.0f - t;
    points.push_back(s * s * s * curve[0] + 3.0f * s * s * t * curve[1] + 3.0f * s * t * t * curve[2] +
                     t * t * t * curve[3]);
  }
}

}  // namespace

std::vector<Tendon> tendonsOf(const glm::mat4& bellyInWorld, const LinePath& line, const glm::vec2& bend) {
  if (!(std::abs(glm::determinant(glm::mat3(bellyInWorld))) > 0.0f)) return {};
  const float towards = glm::dot(glm::vec3(bellyInWorld[1]), line.insertion - line.origin) < 0.0f ? -1.0f : 1.0f;
  std::vector<Tendon> tendons;
  if (auto tendon = tendonTo(bellyInWorld, bend, -towards, line.origin, line.via))
    tendons.push_back(std::move(*tendon));
  if (auto tendon = tendonTo(bellyInWorld, bend, towards, line.insertion, line.via))
    tendons.push_back(std::move(*tendon));
  return tendons;
}

std::vector<glm::vec3> pointsAlong(const LinePath& line) {
  const glm::vec3 across = directionOr(line.insertion - line.origin, glm::vec3(0.0f, 1.0f, 0.0f));
  std::vector<glm::vec3> points{line.origin};
  if (!line.via) {
    addCurve(softCurve(line.origin, across, line.insertion, across), points);
    return points;
  }
  addCurve(softCurve(line.origin, directionOr(*line.via - line.origin, across), *line.via, across), points);
  addCurve(softCurve(*line.via, across, line.insertion, directionOr(line.insertion - *line.via, across)), points);
  return points;
}

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

/// v without its component along a unit vector.
glm::dvec3 partAcross(const glm::dvec3& v, const glm::dvec3& unit) { return v - glm::dot(v, unit) * unit; }

/// Some direction perpendicular to a unit vector.
glm::dvec3 anyAcross(const glm::dvec3& unit) {
  const glm::dvec3 axis = std::abs(unit.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
  return glm::normalize(partAcross(axis, unit));
}

void setFrame(LineRest& rest, const Character& character) {
  const double least = static_cast<double>(kShortestLine * character.height);
  const glm::dvec3 middle = 0.5 * (rest.origin.inBind + rest.insertion.inBind);
  const Bone& origin = at(character.skeleton.bones, rest.origin.bone);
  const glm::dvec3 bone(bindSegment(origin).nearest(glm::vec3(middle)));
  glm::dvec3 height = partAcross(middle - bone, rest.direction);
  if (glm::length(height) < least) height = partAcross(nearestSkin(character.mesh, middle) - middle, rest.direction);
  const glm::dvec3 z = glm::length(height) < least ? anyAcross(rest.direction) : glm::normalize(height);
  rest.frame = {glm::cross(rest.direction, z), rest.direction, z};
  rest.height = std::max(0.0, glm::dot(middle - bone, z));
}

/// Shift of the belly's middle over that of a via point at y, where the belly's ends are -1 and 1: that of a parabola,
/// 1 / (1 - y^2), for |y| < 0.6, fading to 1 at the ends and beyond. C1, at most 1.94.
double viaFactor(double y) {
  constexpr double kParabola = 0.6;
  const double away = std::min(1.0, std::abs(y));
  if (away < kParabola) return 1.0 / (1.0 - y * y);
  const double t = (1.0 - away) / (1.0 - kParabola);
  // t^3 (10 - 15 t + 6 t^2) y^2 / (1 - y^2), without its 0 / 0.
  const double fade = t * t * (10.0 - t * (15.0 - 6.0 * t));
  return 1.0 + fade * away * away / ((1.0 - kParabola) * (1.0 + away));
}

}  // namespace

LineAnchor anchorOn(const Skeleton& skeleton, int bone, const glm::vec3& inBind) {
  return {
      skeleton.fileName(bone), glm::vec3(at(skeleton.bones, bone).inverseBindInWorld * glm::vec4(inBind, 1.0f)), {}};
}

std::optional<BonePoint> findPoint(const LineAnchor& anchor, const Skeleton& skeleton) {
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
  constexpr double kMaxShift = 0.5;  // Fraction of the belly's length.
  const glm::dvec3 there = via - origin;
  const double foot = glm::dot(there, direction);
  const glm::dvec3 beside = there - foot * direction;
  const double half = 0.5 * belly;
  const glm::dvec3 shift = viaFactor((foot - tendon - half) / half) * beside;
  const double length = glm::length(shift), limit = kMaxShift * belly;
  return length > limit ? (limit / length) * shift : shift;
}

Result<LineRest> lineRest(const MuscleLine& line, const Character& character) {
  const std::string subject = "muscle line \"" + line.name + '"';
  LineRest rest;
  const auto take = [&](const LineAnchor& anchor, const char* what, BonePoint& point) -> Result<void> {
    const std::optional<BonePoint> found = findPoint(anchor, character.skeleton);
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
  setFrame(rest, character);
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
