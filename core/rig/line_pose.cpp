// core/rig/line_pose.cpp: the virtual bone between two anchors. docs/muscles.md.
#include "core/rig/line_pose.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/rig/line_rest.h"
#include "sinew/geometry/geometry.h"

namespace sinew {
namespace {

double farthest(const glm::dmat3& a, const glm::dmat3& b) {
  double most = 0.0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) most = std::max(most, std::abs(a[column][row] - b[column][row]));
  }
  return most;
}

}  // namespace

glm::dmat3 nearestRotation(glm::dmat3 matrix) {
  const double determinant = glm::determinant(matrix);
  matrix *= 1.0 / std::cbrt(determinant);  // Negates reflections.
  constexpr int kMostRounds = 60;          // A bone takes about seven; a scale of a million to one takes thirty.
  for (int round = 0; round < kMostRounds; ++round) {
    const glm::dmat3 next = 0.5 * (matrix + glm::inverse(glm::transpose(matrix)));
    const double step = farthest(next, matrix);
    matrix = next;
    if (step < 1e-14) break;
  }
  return matrix;
}

BoneMotion boneMotion(const glm::mat4& bind, const glm::mat4& inverseBind, const glm::mat4& now) {
  BoneMotion motion;
  if (now == bind) return motion;
  motion.moved = true;
  const glm::dmat3 linear = glm::dmat3(glm::dmat4(now)) * glm::dmat3(glm::dmat4(inverseBind));
  if (!isFinite(now) || isFlat(linear)) {
    motion.usable = false;
    return motion;
  }
  motion.scale = std::cbrt(std::abs(glm::determinant(linear)));
  motion.turn = nearestRotation(linear);
  return motion;
}

namespace {

constexpr double kOpposite = 1e-6;   // 1 + cosine below which two directions are opposite.
constexpr double kSamePoint = 1e-6;  // Distance of coinciding anchors, fraction of the length in the bind pose.
constexpr double kMaxFloat = 3.4e38;

/// Points of a line. World.
struct Course {
  glm::dvec3 origin{0.0};
  glm::dvec3 via{0.0};  ///< The middle of a line without via point.
  glm::dvec3 insertion{0.0};
  double length = 0.0;  ///< Through the via point.
};

/// Perpendicular unit vectors. World.
struct LineFrame {
  glm::dvec3 width{0.0};
  glm::dvec3 direction{0.0};
  glm::dvec3 height{0.0};
};

/// Lengths and activation of a line.
struct Contraction {
  double scale = 1.0;       ///< Scale of the bones since the bind pose.
  double restLength = 0.0;  ///< With that scale.
  double stretch = 1.0;
  double bellyStretch = 1.0;
  double activation = 0.0;
};

/// World of the bind pose -> world now.
struct Deformation {
  glm::dmat3 linear{1.0};
  glm::dvec3 shift{0.0};
  glm::dvec3 aside{0.0};  ///< The via point's part of the shift.

  [[nodiscard]] bool isFinite() const {
    const auto size = [](const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
    const double sum = (size(linear[0]) + size(linear[1])) + (size(linear[2]) + size(shift));
    return sum < kMaxFloat;
  }
};

/// Rotates a height, perpendicular to `from`, by the smallest rotation that takes `from` to the line's direction.
glm::dvec3 swingHeight(const glm::dvec3& from, const glm::dvec3& height, const glm::dvec3& direction) {
  const double opening = 1.0 + glm::dot(from, direction);
  if (opening < kOpposite) return height;  // A half turn about the height.
  return height - (glm::dot(height, direction) / opening) * (from + direction);
}

/// Height of two frames' normalized quaternion mixture around a direction. @param a, b  unit, perpendicular to it
glm::dvec3 mixHeights(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& direction, double share) {
  const double cosine = std::min(1.0, std::max(-1.0, glm::dot(a, b)));
  const glm::dvec3 beside = glm::cross(direction, a);
  const double halfCosine = std::sqrt(0.5 * (1.0 + cosine));
  const double halfSine = std::copysign(std::sqrt(0.5 * (1.0 - cosine)), glm::dot(beside, b));
  const double c = 1.0 - share + share * halfCosine;
  const double s = share * halfSine;
  const double whole = 1.0 / (c * c + s * s);
  return ((c * c - s * s) * whole) * a + ((c + c) * s * whole) * beside;
}

/// Bones of one skeleton in one pose; motions are computed on first use.
class PosedBones {
 public:
  PosedBones(const Skeleton& skeleton, const Pose& pose, LineScratch& scratch)
      : skeleton_(skeleton), pose_(pose), motions_(scratch.motions) {
    motions_.assign(skeleton.bones.size(), std::nullopt);
  }

  [[nodiscard]] const BoneMotion& motion(int bone) const {
    std::optional<BoneMotion>& known = at(motions_, bone);
    if (!known) {
      const Bone& inBind = at(skeleton_.bones, bone);
      known = boneMotion(inBind.bindInWorld, inBind.inverseBindInWorld, at(pose_.boneInWorld, bone));
    }
    return *known;
  }
  [[nodiscard]] glm::dvec3 place(const BonePoint& point) const { return posedPoint(point, pose_); }
  /// The bone of a via point only has to be finite.
  [[nodiscard]] bool canCarry(const LineRest& rest) const {
    return motion(rest.origin.bone).usable && motion(rest.insertion.bone).usable &&
           (!rest.via || isFinite(at(pose_.boneInWorld, rest.via->bone)));
  }
  [[nodiscard]] bool anyMoved(const LineRest& rest) const {
    return motion(rest.origin.bone).moved || motion(rest.insertion.bone).moved ||
           (rest.via && motion(rest.via->bone).moved);
  }

 private:
  const Skeleton& skeleton_;
  const Pose& pose_;
  std::vector<std::optional<BoneMotion>>& motions_;
};

Course courseOf(const LineRest& rest, const PosedBones& bones, bool moved) {
  Course course{bones.place(rest.origin), {}, bones.place(rest.insertion), 0.0};
  if (rest.via) {
    course.via = bones.place(*rest.via);
    course.length = glm::length(course.via - course.origin) + glm::length(course.insertion - course.via);
  } else {
    course.via = 0.5 * (course.origin + course.insertion);
    course.length = glm::length(course.insertion - course.origin);
  }
  if (!moved) course.length = rest.length;  // Exactly, so that a line at rest has no activation.
  return course;
}

Contraction contractionOf(const LineRest& rest, const PosedBones& bones, double length, double flex) {
  const LineSettings& settings = rest.settings;
  Contraction now;
  now.scale = std::sqrt(bones.motion(rest.origin.bone).scale * bones.motion(rest.insertion.bone).scale);
  now.restLength = static_cast<double>(settings.rest) * rest.length * now.scale;
  now.stretch = length / now.restLength;
  now.bellyStretch = bellyStretch(now.stretch, settings);
  now.activation = activation(now.stretch, settings, flex);
  return now;
}

LineFrame frameOf(const LineRest& rest, const PosedBones& bones, const Course& course) {
  const glm::dmat3& byOrigin = bones.motion(rest.origin.bone).turn;
  const glm::dmat3& byInsertion = bones.motion(rest.insertion.bone).turn;
  const glm::dvec3 fromOrigin = byOrigin * rest.direction;
  const glm::dvec3 along = course.insertion - course.origin;
  const double straight = glm::length(along);
  LineFrame frame;
  frame.direction = straight > kSamePoint * rest.length ? (1.0 / straight) * along : fromOrigin;
  frame.height = mixHeights(swingHeight(fromOrigin, byOrigin * rest.frame[2], frame.direction),
                            swingHeight(byInsertion * rest.direction, byInsertion * rest.frame[2], frame.direction),
                            frame.direction, static_cast<double>(rest.settings.twist));
  frame.width = glm::cross(frame.direction, frame.height);
  return frame;
}

/// The via point's contribution to the shift since the bind pose.
glm::dvec3 shiftAside(const LineRest& rest, const Course& course, const LineFrame& frame, const Contraction& now,
                      double tendon) {
  const auto& [width, direction, height] = frame;
  const glm::dvec3& drawn = rest.viaShift;
  const glm::dvec3 carried = glm::dot(rest.frame[0], drawn) * width + glm::dot(rest.frame[1], drawn) * direction +
                             glm::dot(rest.frame[2], drawn) * height;
  const double belly = now.bellyStretch * bellyShare(rest.settings) * now.restLength;
  return viaShift(course.origin, direction, course.via, tendon, belly) - now.scale * carried;
}

Deformation deformationOf(const LineRest& rest, const Course& course, const LineFrame& frame, const Contraction& now) {
  const auto& [width, direction, height] = frame;
  const glm::dvec2 flex(rest.settings.flex);
  const double omega = now.scale * girth(now.bellyStretch, rest.girth);
  const glm::dvec3 ofWidth = (omega * (1.0 + flex.y * now.activation)) * rest.frame[0];
  const glm::dvec3 ofDirection = (now.scale * now.bellyStretch / rest.bellyStretch) * rest.frame[1];
  const glm::dvec3 ofHeight = (omega * (1.0 + flex.x * now.activation)) * rest.frame[2];
  Deformation deformation;
  for (int i = 0; i < 3; ++i) {
    deformation.linear[i] = ofWidth[i] * width + ofDirection[i] * direction + ofHeight[i] * height;
  }
  const double tendon = static_cast<double>(rest.settings.tendons.x) * now.restLength;
  deformation.shift =
      course.origin + tendon * direction - (now.scale * rest.depth) * height - deformation.linear * rest.start;
  if (!rest.via) return deformation;
  deformation.aside = shiftAside(rest, course, frame, now, tendon);
  deformation.shift += deformation.aside;
  return deformation;
}

PosedLine poseLine(const LineRest& rest, const PosedBones& bones, double flex) {
  if (!bones.canCarry(rest)) return {};
  const bool moved = bones.anyMoved(rest);
  const Course course = courseOf(rest, bones, moved);
  const Contraction now = contractionOf(rest, bones, course.length, flex);
  const LineFrame frame = frameOf(rest, bones, course);
  const bool asDrawn = !moved && now.activation == 0.0;  // If nothing has moved, muscles stay bit for bit as drawn.
  const Deformation deformation = asDrawn ? Deformation{} : deformationOf(rest, course, frame, now);
  if (!deformation.isFinite()) return {};
  PosedLine line;
  line.deformation = glm::mat4(glm::mat3(deformation.linear));
  line.deformation[3] = glm::vec4(glm::vec3(deformation.shift), 1.0f);
  line.origin = glm::vec3(course.origin);
  line.via = glm::vec3(course.via);
  line.insertion = glm::vec3(course.insertion);
  line.height = glm::vec3(frame.height);
  line.stretch = static_cast<float>(now.stretch);
  line.bellyStretch = static_cast<float>(now.bellyStretch);
  line.activation = static_cast<float>(now.activation);
  line.aside = glm::vec3(deformation.aside);
  line.usable = true;
  return line;
}

}  // namespace

void poseLines(std::span<const std::optional<LineRest>> lines, const Skeleton& skeleton, const Pose& pose,
               LineScratch& scratch, std::vector<PosedLine>& out) {
  const PosedBones bones(skeleton, pose, scratch);
  out.resize(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto flex = static_cast<double>(pose.flexOf(static_cast<int>(i)));
    out[i] = lines[i] ? poseLine(*lines[i], bones, flex) : PosedLine{};
  }
}

PosedLine posedLine(const LineRest& rest, const Skeleton& skeleton, const Pose& pose, float flex) {
  LineScratch scratch;
  return poseLine(rest, PosedBones(skeleton, pose, scratch), static_cast<double>(flex));
}

glm::mat4 carrierInWorld(int bone, int line, const Skeleton& skeleton, const Pose& pose,
                         std::span<const PosedLine> lines) {
  if (line < 0) return at(pose.boneInWorld, bone);
  return lines[static_cast<std::size_t>(line)].deformation * at(skeleton.bones, bone).bindInWorld;
}

}  // namespace sinew
