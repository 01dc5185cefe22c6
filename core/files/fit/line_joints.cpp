// core/files/fit/line_joints.cpp: where lines' joints stand, and their locals in a pose.
#include "core/files/fit/line_joints.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

constexpr double kEven = 1e-4;  ///< Share of the scale: less unevenness does not count.

/// Turns and scales alike in all directions.
bool isSimilarity(const glm::mat4& matrix) {
  const glm::dmat3 m{glm::mat3(matrix)};
  const double size = glm::dot(m[0], m[0]);
  if (!(size > 0.0)) return false;
  return std::abs(glm::dot(m[1], m[1]) - size) <= kEven * size &&
         std::abs(glm::dot(m[2], m[2]) - size) <= kEven * size && std::abs(glm::dot(m[0], m[1])) <= kEven * size &&
         std::abs(glm::dot(m[1], m[2])) <= kEven * size && std::abs(glm::dot(m[2], m[0])) <= kEven * size;
}

/// [bones]
std::vector<bool> evenBones(const Skeleton& skeleton, std::span<const Pose> poses) {
  std::vector<bool> even;
  for (const Bone& bone : skeleton.bones) even.push_back(isSimilarity(bone.bindInWorld));
  for (const Pose& pose : poses) {
    for (std::size_t bone = 0; bone < even.size(); ++bone)
      even[bone] = even[bone] && isSimilarity(pose.boneInWorld[bone]);
  }
  return even;
}

int parentFor(int bone, const Skeleton& skeleton, const std::vector<bool>& even) {
  for (int at_ = bone; at_ >= 0; at_ = at(skeleton.bones, at_).parent) {
    if (even[toIndex(at_)]) return at_;
  }
  return bone;
}

/// Under the middle of the belly: where its girth grows from.
glm::dvec3 middleOf(const LineRest& rest) {
  const glm::dvec2 tendons(rest.settings.tendons);
  const double belly = rest.bellyStretch * (1.0 - tendons.x - tendons.y) * static_cast<double>(rest.settings.rest);
  return rest.start + 0.5 * belly * rest.length * rest.direction;
}

/// How far the muscles of a line rise above a point, along the line's height; at least a little.
double riseOver(const glm::dvec3& point, const LineRest& rest, int line, const Rig& rig, const Skeleton& skeleton) {
  double rise = 0.05 * rest.length;
  for (const Primitive& primitive : rig.primitives) {
    const auto bone = skeleton.findBone(primitive.bone);
    if (primitive.line != at(rig.lines, line).name || !bone) continue;
    const glm::dmat4 inWorld(at(skeleton.bones, *bone).bindInWorld);
    const glm::dvec3 center(inWorld * glm::dvec4(glm::dvec3(primitive.placement.center), 1.0));
    const glm::vec3& radii = primitive.placement.radii;
    const double radius =
        static_cast<double>(std::min({radii.x, radii.y, radii.z})) * glm::length(glm::dvec3(inWorld[0]));
    rise = std::max(rise, glm::dot(center - point, rest.frame[2]) + radius);
  }
  return rise;
}

bool carriesMuscle(const Rig& rig, const std::string& line) {
  return std::ranges::any_of(rig.primitives, [&](const Primitive& primitive) { return primitive.line == line; });
}

}  // namespace

LineJoints::LineJoints(const Rig& rig, const Character& character, JointScale scale, std::span<const Pose> poses)
    : character_(&character), scale_(scale), rests_(lineRests(rig, character)) {
  if (rig.lines.empty()) return;
  poser_.emplace(rig, character);
  for (const MuscleLine& line : rig.lines) names_.push_back(line.name);
  const Skeleton& skeleton = character.skeleton;
  const Pose bind = bindPose(skeleton);
  const PosedRig posed = poser_->pose(bind);
  for (const PosedLine& line : posed.lines) {
    const glm::dmat4 deformation(line.deformation);
    fromBind_.push_back(line.usable && glm::determinant(deformation) > 0.0 ? glm::inverse(deformation)
                                                                           : glm::dmat4(1.0));
  }
  const std::vector<bool> even = evenBones(skeleton, poses);
  for (std::size_t i = 0; i < rests_.size(); ++i) {
    if (!rests_[i] || !carriesMuscle(rig, rig.lines[i].name)) continue;
    const LineRest& rest = *rests_[i];
    const int line = static_cast<int>(i);
    const int bone = parentFor(rest.origin.bone, skeleton, even);
    const glm::dvec3 middle = middleOf(rest);
    add(line, rig.lines[i].name, bone, middle);
    if (scale_ != JointScale::kNone) continue;
    add(line, rig.lines[i].name + " top", bone, middle + riseOver(middle, rest, line, rig, skeleton) * rest.frame[2]);
  }
}

void LineJoints::add(int line, std::string name, int bone, const glm::dvec3& place) {
  glm::dmat4 world(at(rests_, line)->frame);
  world[3] = glm::dvec4(place, 1.0);
  Trs rest = trsOf(glm::inverse(glm::dmat4(at(character_->skeleton.bones, bone).bindInWorld)) * world);
  rest.scale = glm::dvec3(1.0);
  joints_.push_back(makeHelper(std::move(name), bone, rest, character_->skeleton));
  joints_.back().line = line;
}

void LineJoints::pose(const Pose& pose, std::vector<Trs>& locals) const {
  locals.clear();
  if (joints_.empty()) return;
  const std::vector<PosedLine> lines = poser_->pose(pose).lines;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const HelperJoint& joint = joints_[j];
    const PosedLine& line = at(lines, joint.line);
    const std::optional<glm::dmat4> intoParent = fromWorld(pose, joint.bone);
    if (!line.usable || line.deformation == glm::mat4(0.0f) || !intoParent) {
      locals.push_back(joint.rest);
      continue;
    }
    const glm::dmat4 motion = glm::dmat4(line.deformation) * at(fromBind_, joint.line);
    const glm::dmat4 inBind =
        glm::dmat4(at(character_->skeleton.bones, joint.bone).bindInWorld) * joint.rest.toMatrix();
    Trs local = trsOf(*intoParent * motion * inBind);
    const double even = std::sqrt(local.scale.x * local.scale.z);
    if (scale_ == JointScale::kUniform) local.scale = glm::dvec3(even);
    if (scale_ == JointScale::kNone) local.scale = glm::dvec3(1.0);
    locals.push_back(roundToFloats(local));
  }
}

void LineJoints::keep(const std::vector<bool>& kept) {
  std::size_t next = 0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (kept[j]) joints_[next++] = joints_[j];
  }
  joints_.resize(next);
}

}  // namespace sinew::exporting
