// core/lines/line_pose.cpp: the virtual bone that two anchors span.
#include "core/lines/line_pose.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/lines/contraction.h"
#include "sinew/base/geometry.h"

namespace sinew {
namespace {

constexpr double kOpposite = 1e-6;   // 1 + cosine below which two directions are opposite.
constexpr double kSamePoint = 1e-6;  // Of the rest length: anchors that meet have no direction.

/// Least rotation of p to q, both unit; `axis`, square to p, where any would do.
glm::dquat swing(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& axis) {
  const double cosine = glm::dot(p, q);
  if (1.0 + cosine < kOpposite) return {0.0, axis.x, axis.y, axis.z};
  const glm::dvec3 turn = glm::cross(p, q);
  return glm::normalize(glm::dquat(1.0 + cosine, turn.x, turn.y, turn.z));
}

/// The bind frame as one bone carries it, swung onto the line.
glm::dquat carried(const LineRest& rest, const BoneMotion& bone, const glm::dvec3& direction) {
  const glm::dquat turned = bone.turn * rest.frame;
  return swing(bone.turn * rest.direction, direction, turned * glm::dvec3(0.0, 0.0, 1.0)) * turned;
}

/// Both take the line's axis to its direction, and so does every mixture.
glm::dquat mixed(const glm::dquat& a, glm::dquat b, double share) {
  if (glm::dot(a, b) < 0.0) b = -b;
  return glm::normalize((1.0 - share) * a + share * b);
}

struct Ends {
  glm::dvec3 origin;
  glm::dvec3 insertion;
  glm::dvec3 via;
  double length = 0.0;
};

glm::dvec3 posed(const BonePoint& point, const Pose& pose) {
  return glm::dvec3(glm::dmat4(at(pose.boneInWorld, point.bone)) * glm::dvec4(point.inBone, 1.0));
}

Ends endsOf(const LineRest& rest, const Pose& pose) {
  Ends ends{posed(rest.origin, pose), posed(rest.insertion, pose), glm::dvec3(0.0)};
  ends.via = rest.via ? posed(*rest.via, pose) : 0.5 * (ends.origin + ends.insertion);
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
  const double omega = girth(belly, rest.settings);
  const glm::dvec2 flex(rest.settings.flex);
  const auto a = static_cast<double>(line.activation);
  return scale * glm::dvec3(omega * (1.0 + flex.y * a), belly / rest.bellyStretch, omega * (1.0 + flex.x * a));
}

void deform(const LineRest& rest, const Motions& motions, const Ends& ends, double scale, PosedLine& line) {
  const glm::dvec3 along = ends.insertion - ends.origin;
  const double straight = glm::length(along);
  const glm::dvec3 direction =
      straight > kSamePoint * rest.length ? along / straight : motions.origin.turn * rest.direction;
  const glm::dquat frame = mixed(carried(rest, motions.origin, direction), carried(rest, motions.insertion, direction),
                                 static_cast<double>(rest.settings.twist));
  const glm::dvec3 height = frame * glm::dvec3(0.0, 0.0, 1.0);
  const double restLength = static_cast<double>(rest.settings.rest) * rest.length * scale;
  const glm::dvec3 start =
      ends.origin + static_cast<double>(rest.settings.tendons.x) * restLength * direction - scale * rest.depth * height;

  glm::dmat3 stretched = glm::mat3_cast(frame);
  const glm::dvec3 growth = factors(rest, line, scale);
  for (int axis = 0; axis < 3; ++axis) stretched[axis] *= growth[axis];
  const glm::dmat3 toFrame = glm::transpose(glm::mat3_cast(rest.frame));
  const glm::dmat3 linear = stretched * toFrame;
  glm::dmat4 deformation(linear);
  deformation[3] = glm::dvec4(start - linear * rest.start, 1.0);
  if (rest.via) {
    const glm::dvec2 tendons(rest.settings.tendons);
    const double belly = static_cast<double>(line.bellyStretch) * (1.0 - tendons.x - tendons.y) * restLength;
    const glm::dvec3 now = viaShift(ends.origin, direction, ends.via, tendons.x * restLength, belly);
    const glm::dvec3 drawn = scale * (glm::mat3_cast(frame) * (toFrame * rest.viaShift));
    deformation[3] += glm::dvec4(now - drawn, 0.0);
  }
  line.deformation = glm::mat4(deformation);
  line.height = glm::vec3(height);
}

PosedLine poseLine(const LineRest& rest, const Motions& motions, const Pose& pose) {
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
  line.activation = static_cast<float>(activation(stretch, rest.settings, static_cast<double>(pose.flex)));
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
    out[i] = poseLine(rest, motions, pose);
    if (out[i].usable && out[i].activation == 0.0f && restsInBind(rest, motions, skeleton, pose)) {
      out[i].deformation = glm::mat4(1.0f);
    }
  }
}

glm::mat4 carrierInWorld(int bone, int line, const Skeleton& skeleton, const Pose& pose,
                         std::span<const PosedLine> lines) {
  if (line < 0) return at(pose.boneInWorld, bone);
  return lines[static_cast<std::size_t>(line)].deformation * at(skeleton.bones, bone).bindInWorld;
}

}  // namespace sinew
