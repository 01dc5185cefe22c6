// tests/support/oracle/line.cpp: one line at a time, with quaternions and the standard library's functions.
#include "tests/support/oracle/line.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

#include "core/rig/line_pose.h"

namespace sinew::oracle {
namespace {

double softened(double stretch, const LineSettings& settings) {
  const double x = std::log(stretch);
  const double m =
      x < 0.0 ? -std::log(static_cast<double>(settings.limits.x)) : std::log(static_cast<double>(settings.limits.y));
  return m * std::tanh(x / m);
}

double bellyOf(double stretch, const LineSettings& settings) {
  const glm::dvec2 tendons(settings.tendons);
  const double belly = 1.0 - tendons.x - tendons.y;
  return std::max(stretch - tendons.x - tendons.y, 0.1 * belly) / belly;
}

double activationOf(double stretch, const LineSettings& settings, double flex) {
  const double s = std::clamp((1.0 - stretch) / (1.0 - static_cast<double>(settings.full)), 0.0, 1.0);
  const double gain = static_cast<double>(settings.gain);
  return std::clamp(static_cast<double>(settings.base) + flex + gain * s * s * (3.0 - 2.0 * s), 0.0, 1.0);
}

/// The least rotation; a half turn about `axis` where they are opposite.
glm::dquat swing(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& axis) {
  const double opening = 1.0 + glm::dot(from, to);
  if (opening < 1e-6) return {0.0, axis.x, axis.y, axis.z};
  const glm::dvec3 across = glm::cross(from, to);
  return glm::normalize(glm::dquat(opening, across.x, across.y, across.z));
}

glm::dvec3 viaShift(const glm::dvec3& origin, const glm::dvec3& u, const glm::dvec3& via, double tendon, double belly) {
  const double along = glm::dot(via - origin, u);
  const glm::dvec3 beside = via - (origin + along * u);
  const double y = std::abs((along - tendon - 0.5 * belly) / (0.5 * belly));
  const double t = std::clamp((1.0 - y) / 0.4, 0.0, 1.0);
  const double parabola = y < 1.0 ? 1.0 / (1.0 - y * y) : 1.0;
  const glm::dvec3 shift = (1.0 + t * t * t * (10.0 - 15.0 * t + 6.0 * t * t) * (parabola - 1.0)) * beside;
  const double most = 0.5 * belly / std::max(glm::length(shift), 1e-300);
  return std::min(1.0, most) * shift;
}

}  // namespace

double girth(double stretch, const LineSettings& settings) {
  const double inBind = bellyOf(1.0 / static_cast<double>(settings.rest), settings);
  const double volume = static_cast<double>(settings.volume);
  return std::exp(-0.5 * volume * (softened(stretch, settings) - softened(inBind, settings)));
}

Line posedLine(const LineRest& rest, const Skeleton& skeleton, const Pose& pose, double flex) {
  const LineSettings& settings = rest.settings;
  const auto motionOf = [&](const BonePoint& point) {
    const auto bone = static_cast<std::size_t>(point.bone);
    const Bone& of = skeleton.bones[bone];
    return boneMotion(of.bindInWorld, of.inverseBindInWorld, pose.boneInWorld[bone]);
  };
  const auto now = [&](const BonePoint& point) {
    const glm::mat4& bone = pose.boneInWorld[static_cast<std::size_t>(point.bone)];
    return glm::dvec3(glm::dmat4(bone) * glm::dvec4(point.inBone, 1.0));
  };
  const BoneMotion first = motionOf(rest.origin);
  const BoneMotion second = motionOf(rest.insertion);
  const double scale = std::sqrt(first.scale * second.scale);

  Line line;
  line.origin = now(rest.origin);
  line.insertion = now(rest.insertion);
  line.via = rest.via ? now(*rest.via) : 0.5 * (line.origin + line.insertion);
  const double straight = glm::distance(line.origin, line.insertion);
  const double bent = glm::distance(line.origin, line.via) + glm::distance(line.via, line.insertion);
  const double restLength = static_cast<double>(settings.rest) * rest.length * scale;
  line.stretch = (rest.via ? bent : straight) / restLength;
  line.bellyStretch = bellyOf(line.stretch, settings);
  line.activation = activationOf(line.stretch, settings, flex);

  const glm::dvec3 along = line.insertion - line.origin;
  const glm::dvec3 u = straight > 1e-6 * rest.length ? along / straight : first.turn * rest.direction;
  const auto carried = [&](const BoneMotion& motion) {
    const glm::dvec3 axis = motion.turn * rest.frame[2];
    return swing(motion.turn * rest.direction, u, axis) * glm::quat_cast(motion.turn * rest.frame);
  };
  const glm::dquat qi = carried(first);
  const glm::dquat qj = carried(second);
  line.agreement = std::abs(glm::dot(qi, qj));
  const double twist = static_cast<double>(settings.twist);
  const double sign = glm::dot(qi, qj) < 0.0 ? -1.0 : 1.0;
  const glm::dmat3 frame = glm::mat3_cast(glm::normalize((1.0 - twist) * qi + sign * twist * qj));
  line.height = frame[2];

  const double omega = girth(line.bellyStretch, settings);
  const glm::dvec2 flexes(settings.flex);
  const glm::dvec2 tendons(settings.tendons);
  const double inBind = bellyOf(1.0 / static_cast<double>(settings.rest), settings);
  const glm::dmat3 grow(scale * omega * (1.0 + flexes.y * line.activation), 0, 0, 0, scale * line.bellyStretch / inBind,
                        0, 0, 0, scale * omega * (1.0 + flexes.x * line.activation));
  const glm::dmat3 linear = frame * grow * glm::transpose(rest.frame);
  const double depth = static_cast<double>(settings.pivot) * rest.height;
  const double restInBind = static_cast<double>(settings.rest) * rest.length;
  const glm::dvec3 p0 = rest.origin.inBind + tendons.x * restInBind * rest.direction - depth * rest.frame[2];
  glm::dvec3 p = line.origin + tendons.x * restLength * u - scale * depth * line.height;
  if (rest.via) {
    const double share = 1.0 - tendons.x - tendons.y;
    const glm::dvec3 v0 = viaShift(rest.origin.inBind, rest.direction, rest.via->inBind, tendons.x * restInBind,
                                   inBind * share * restInBind);
    p += viaShift(line.origin, u, line.via, tendons.x * restLength, line.bellyStretch * share * restLength);
    p -= scale * (frame * glm::transpose(rest.frame) * v0);
  }
  line.deformation = glm::dmat4(linear);
  line.deformation[3] = glm::dvec4(p - linear * p0, 1.0);
  return line;
}

}  // namespace sinew::oracle
