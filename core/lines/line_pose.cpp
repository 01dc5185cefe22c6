// core/lines/line_pose.cpp: the virtual bone that two anchors span.
#include "core/lines/line_pose.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/lines/contraction.h"
#include "sinew/base/geometry.h"

namespace sinew {
namespace {

constexpr double kOpposite = 1e-6;   // 1 + cosine below which two directions are opposite.
constexpr double kSamePoint = 1e-6;  // Of the rest length: anchors that meet have no direction.

/// The bind frame's height as one bone carries it, after the least rotation that takes the carried direction onto the
/// line: what is square to a direction loses its part along the new one in the plane of both.
glm::dvec3 carriedHeight(const LineRest& rest, const BoneMotion& bone, const glm::dvec3& direction) {
  const glm::dvec3 from = bone.turn * rest.frame[1];
  const glm::dvec3 height = bone.turn * rest.frame[2];
  const double opening = 1.0 + glm::dot(from, direction);
  if (opening < kOpposite) return height;  // A half turn about the height: any would do.
  return height - (glm::dot(height, direction) / opening) * (from + direction);
}

/// The normalised mixture of the quaternions of two frames around one direction, as the height it gives. Half their
/// angle apart, the mixture of their half-angle vectors is the half angle from the first.
/// @param a, b  unit, square to the direction
glm::dvec3 mixedHeight(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& direction, double share) {
  const double cosine = std::clamp(glm::dot(a, b), -1.0, 1.0);
  const glm::dvec3 beside = glm::cross(direction, a);
  const double halfCosine = std::sqrt(0.5 * (1.0 + cosine));
  const double halfSine = std::copysign(std::sqrt(0.5 * (1.0 - cosine)), glm::dot(beside, b));
  const double c = 1.0 - share + share * halfCosine;
  const double s = share * halfSine;
  const double square = c * c + s * s;
  return ((c * c - s * s) / square) * a + (2.0 * c * s / square) * beside;
}

struct Ends {
  glm::dvec3 origin;
  glm::dvec3 insertion;
  glm::dvec3 via;
  double length = 0.0;
};

Ends endsOf(const LineRest& rest, const Pose& pose) {
  Ends ends{posedPoint(rest.origin, pose), posedPoint(rest.insertion, pose), glm::dvec3(0.0)};
  ends.via = rest.via ? posedPoint(*rest.via, pose) : 0.5 * (ends.origin + ends.insertion);
  ends.length = rest.via ? glm::distance(ends.origin, ends.via) + glm::distance(ends.via, ends.insertion)
                         : glm::distance(ends.origin, ends.insertion);
  return ends;
}

struct Motions {
  BoneMotion origin;
  BoneMotion insertion;
};

/// Factors of the deformation along the frame's axes.
glm::dvec3 factors(const LineRest& rest, const PosedLine& line, double scale) {
  const auto belly = static_cast<double>(line.bellyStretch);
  const double omega = girth(belly, rest.girth);
  const glm::dvec2 flex(rest.settings.flex);
  const auto a = static_cast<double>(line.activation);
  return scale * glm::dvec3(omega * (1.0 + flex.y * a), belly / rest.bellyStretch, omega * (1.0 + flex.x * a));
}

void deform(const LineRest& rest, const Motions& motions, const Ends& ends, double scale, PosedLine& line) {
  const glm::dvec3 along = ends.insertion - ends.origin;
  const double straight = glm::length(along);
  const glm::dvec3 direction =
      straight > kSamePoint * rest.length ? along / straight : motions.origin.turn * rest.direction;
  const glm::dvec3 height =
      mixedHeight(carriedHeight(rest, motions.origin, direction), carriedHeight(rest, motions.insertion, direction),
                  direction, static_cast<double>(rest.settings.twist));
  const glm::dvec3 width = glm::cross(direction, height);
  const double restLength = static_cast<double>(rest.settings.rest) * rest.length * scale;
  const glm::dvec3 start =
      ends.origin + static_cast<double>(rest.settings.tendons.x) * restLength * direction - scale * rest.depth * height;

  const glm::dvec3 growth = factors(rest, line, scale);
  const glm::dmat3 toFrame = glm::transpose(rest.frame);
  const glm::dmat3 linear = glm::dmat3(growth.x * width, growth.y * direction, growth.z * height) * toFrame;
  glm::dmat4 deformation(linear);
  deformation[3] = glm::dvec4(start - linear * rest.start, 1.0);
  if (rest.via) {
    const glm::dvec2 tendons(rest.settings.tendons);
    const double belly = static_cast<double>(line.bellyStretch) * (1.0 - tendons.x - tendons.y) * restLength;
    const glm::dvec3 now = viaShift(ends.origin, direction, ends.via, tendons.x * restLength, belly);
    const glm::dvec3 drawn = scale * (glm::dmat3(width, direction, height) * (toFrame * rest.viaShift));
    deformation[3] += glm::dvec4(now - drawn, 0.0);
  }
  line.deformation = glm::mat4(deformation);
  line.height = glm::vec3(height);
}

PosedLine poseLine(const LineRest& rest, const Motions& motions, const Pose& pose, float flex) {
  PosedLine line;
  const bool viaMoved = rest.via && !isFinite(at(pose.boneInWorld, rest.via->bone));
  if (!motions.origin.usable || !motions.insertion.usable || viaMoved) return line;
  const Ends ends = endsOf(rest, pose);
  const double scale = std::sqrt(motions.origin.scale * motions.insertion.scale);
  const double stretch = ends.length / (static_cast<double>(rest.settings.rest) * rest.length * scale);
  line.origin = glm::vec3(ends.origin);
  line.via = glm::vec3(ends.via);
  line.insertion = glm::vec3(ends.insertion);
  line.stretch = static_cast<float>(stretch);
  line.bellyStretch = static_cast<float>(bellyStretch(stretch, rest.settings));
  line.activation = static_cast<float>(activation(stretch, rest.settings, static_cast<double>(flex)));
  deform(rest, motions, ends, scale, line);
  line.usable = isFinite(line.deformation);
  if (!line.usable) line.deformation = glm::mat4(0.0f);
  return line;
}

/// Nothing has moved: what the designer drew is there, bit for bit.
bool restsInBind(const LineRest& rest, const Motions& motions, const Skeleton& skeleton, const Pose& pose) {
  if (motions.origin.moved || motions.insertion.moved) return false;
  return !rest.via || at(pose.boneInWorld, rest.via->bone) == at(skeleton.bones, rest.via->bone).bindInWorld;
}

PosedLine poseOne(const LineRest& rest, const Motions& motions, const Skeleton& skeleton, const Pose& pose,
                  float flex) {
  PosedLine line = poseLine(rest, motions, pose, flex);
  if (line.usable && line.activation == 0.0f && restsInBind(rest, motions, skeleton, pose)) {
    line.deformation = glm::mat4(1.0f);
  }
  return line;
}

}  // namespace

void poseLines(std::span<const std::optional<LineRest>> rests, const Skeleton& skeleton, const Pose& pose,
               LineScratch& scratch, std::vector<PosedLine>& out) {
  scratch.motionOf.assign(skeleton.bones.size(), std::nullopt);
  const auto motionOf = [&](int bone) -> const BoneMotion& {
    std::optional<BoneMotion>& motion = scratch.motionOf[static_cast<std::size_t>(bone)];
    const Bone& of = at(skeleton.bones, bone);
    if (!motion) motion = boneMotion(of.bindInWorld, of.inverseBindInWorld, at(pose.boneInWorld, bone));
    return *motion;
  };
  out.assign(rests.size(), {});
  for (std::size_t i = 0; i < rests.size(); ++i) {
    if (!rests[i]) continue;
    const LineRest& rest = *rests[i];
    const Motions motions{motionOf(rest.origin.bone), motionOf(rest.insertion.bone)};
    out[i] = poseOne(rest, motions, skeleton, pose, pose.flexOf(static_cast<int>(i)));
  }
}

PosedLine posedLine(const LineRest& rest, const Skeleton& skeleton, const Pose& pose, float flex) {
  const auto motionOf = [&](int bone) {
    const Bone& of = at(skeleton.bones, bone);
    return boneMotion(of.bindInWorld, of.inverseBindInWorld, at(pose.boneInWorld, bone));
  };
  return poseOne(rest, {motionOf(rest.origin.bone), motionOf(rest.insertion.bone)}, skeleton, pose, flex);
}

glm::mat4 carrierInWorld(int bone, int line, const Skeleton& skeleton, const Pose& pose,
                         std::span<const PosedLine> lines) {
  if (line < 0) return at(pose.boneInWorld, bone);
  return lines[static_cast<std::size_t>(line)].deformation * at(skeleton.bones, bone).bindInWorld;
}

}  // namespace sinew
