// core/files/fit/helper_motion.cpp: transforms, rigid motions, and the joints of muscle lines.
#include "core/files/fit/helper_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/files/fit/own_eigen.h"

namespace sinew::exporting {

glm::dmat4 Trs::toMatrix() const {
  const glm::dmat3 turn = glm::mat3_cast(rotation);
  return {glm::dvec4(scale.x * turn[0], 0.0), glm::dvec4(scale.y * turn[1], 0.0), glm::dvec4(scale.z * turn[2], 0.0),
          glm::dvec4(translation, 1.0)};
}

Trs trsOf(const glm::dmat4& matrix) {
  Trs result;
  result.translation = glm::dvec3(matrix[3]);
  const glm::dvec3 x(matrix[0]);
  const glm::dvec3 y(matrix[1]);
  const glm::dvec3 z(matrix[2]);
  result.scale = {glm::length(x), glm::length(y), glm::length(z)};
  const glm::dvec3 across = glm::cross(x, y);
  if (!(glm::length(across) > 0.0) || !(result.scale.z > 0.0)) {
    result.scale = glm::dvec3(0.0);
    return result;
  }
  const glm::dvec3 along = y / result.scale.y;
  const glm::dvec3 up = glm::normalize(across);
  result.rotation = glm::normalize(glm::quat_cast(glm::dmat3(glm::cross(along, up), along, up)));
  return result;
}

Trs roundToFloats(const Trs& exact) {
  const glm::quat turn(exact.rotation);
  return {glm::dvec3(glm::vec3(exact.translation)), glm::normalize(glm::dquat(turn)),
          glm::dvec3(glm::vec3(exact.scale))};
}

constexpr double kFlat = 1e-5;  ///< Determinant relative to a uniform scale of the same size.

HelperJoint makeHelper(std::string name, int bone, const Trs& rest, const Skeleton& skeleton) {
  const Trs held = roundToFloats(rest);
  const glm::dmat4 inBind = glm::dmat4(at(skeleton.bones, bone).bindInWorld) * held.toMatrix();
  return {std::move(name), bone, held, glm::dmat4(glm::mat4(glm::inverse(inBind))), -1};
}

glm::dmat4 helperMatrix(const HelperJoint& joint, const Pose& pose, const Trs& local) {
  return glm::dmat4(at(pose.boneInWorld, joint.bone)) * local.toMatrix() * joint.inverseBind;
}

std::optional<glm::dmat4> fromWorld(const Pose& pose, int bone) {
  const glm::dmat4 inWorld(at(pose.boneInWorld, bone));
  const glm::dmat3 axes(inWorld);
  const double longest = std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
  if (!(std::abs(glm::determinant(axes)) > kFlat * longest * longest * longest)) return std::nullopt;
  return glm::inverse(inWorld);
}

void RigidMotion::add(const glm::dvec3& from, const glm::dvec3& to, double weight) {
  weight_ += weight;
  from_ += weight * from;
  to_ += weight * to;
  const glm::dvec3 scaled = weight * to;
  products_[0] += from.x * scaled;
  products_[1] += from.y * scaled;
  products_[2] += from.z * scaled;
}

RigidMotion::Motion RigidMotion::best() const {
  if (!(weight_ > 0.0)) return {};
  const glm::dvec3 from = from_ / weight_;
  const glm::dvec3 to = to_ / weight_;
  // The rotation is the largest eigenvector of n. s(i, k): the sum of (from - mean)[i] * (to - mean)[k].
  const auto s = [&](int i, int k) { return products_[i][k] - from_[i] * to[k]; };
  Eigen::Matrix4d n;
  n << s(0, 0) + s(1, 1) + s(2, 2), s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0),  //
      s(1, 2) - s(2, 1), s(0, 0) - s(1, 1) - s(2, 2), s(0, 1) + s(1, 0), s(2, 0) + s(0, 2),   //
      s(2, 0) - s(0, 2), s(0, 1) + s(1, 0), s(1, 1) - s(0, 0) - s(2, 2), s(1, 2) + s(2, 1),   //
      s(0, 1) - s(1, 0), s(2, 0) + s(0, 2), s(1, 2) + s(2, 1), s(2, 2) - s(0, 0) - s(1, 1);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(n);
  const Eigen::Vector4d q = solver.eigenvectors().col(3);
  Motion motion;
  motion.rotation = glm::normalize(glm::dquat(q[0], q[1], q[2], q[3]));
  if (motion.rotation.w < 0.0) motion.rotation = -motion.rotation;
  motion.translation = to - motion.rotation * from;
  return motion;
}

/// How much a helper is held at rest, as a fraction of its vertices' weights: one that nothing moves stays.
constexpr double kHold = 1e-3;

HelperMotion::HelperMotion(const Skeleton& skeleton, std::span<const glm::vec3> rest,
                           std::span<const FourWeights> weights, std::span<const HelperJoint> helpers, int first)
    : rest_(rest), weights_(weights), joints_(helpers), helpers_(helpers.size()), first_(first) {
  for (std::size_t h = 0; h < helpers.size(); ++h) {
    helpers_[h].intoBone = glm::dmat4(at(skeleton.bones, helpers[h].bone).inverseBindInWorld);
  }
  for (std::size_t v = 0; v < weights.size(); ++v) {
    for (std::size_t i = 0; i < kMostWeights && weights[v].binding[i] >= 0; ++i) {
      if (weights[v].binding[i] < first) continue;
      const int h = weights[v].binding[i] - first;
      Helper& helper = at(helpers_, h);
      const auto weight = static_cast<double>(weights[v].weight[i]);
      const glm::dvec3 point = carryPoint(helper.intoBone, glm::dvec3(rest[v]));
      helper.vertices.push_back(static_cast<int>(v));
      helper.spread += weight * weight * glm::distance(point, at(helpers, h).rest.translation);
      helper.hold += weight * weight;
    }
  }
  for (Helper& helper : helpers_) {
    if (helper.hold > 0.0) helper.spread /= helper.hold;
    helper.hold *= kHold;
  }
}

void HelperMotion::solveOne(std::size_t helper, const Pose& pose, std::span<const glm::dmat4> all,
                            std::span<const glm::vec3> live, Trs& local) const {
  const Helper& own = helpers_[helper];
  if (own.vertices.empty()) return;
  const glm::dvec3 place = joints_[helper].rest.translation;
  const std::optional<glm::dmat4> intoBone = fromWorld(pose, joints_[helper].bone);
  if (!intoBone) {
    local = joints_[helper].rest;
    return;
  }
  RigidMotion motion;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 aside(0.0);
    aside[axis] = own.spread;
    motion.add(aside, aside, own.hold / 6.0);
    motion.add(-aside, -aside, own.hold / 6.0);
  }
  const int self = first_ + static_cast<int>(helper);
  for (const int v : own.vertices) {
    const FourWeights& weights = weights_[toIndex(v)];
    const glm::dvec3 point(rest_[toIndex(v)]);
    glm::dvec3 wanted(live[toIndex(v)]);
    double weight = 0.0;
    for (std::size_t i = 0; i < kMostWeights && weights.binding[i] >= 0; ++i) {
      const auto share = static_cast<double>(weights.weight[i]);
      if (weights.binding[i] == self) weight = share;
      else wanted -= share * carryPoint(all[toIndex(weights.binding[i])], point);
    }
    const glm::dvec3 from = carryPoint(own.intoBone, point) - place;
    motion.add(from, carryPoint(*intoBone, wanted / weight) - place, weight * weight);
  }
  const RigidMotion::Motion best = motion.best();
  local = roundToFloats({place + best.translation, best.rotation, glm::dvec3(1.0)});
}

void HelperMotion::solve(const Pose& pose, std::span<const glm::dmat4> matrices, std::span<const glm::vec3> live,
                         int rounds, std::vector<Trs>& locals) const {
  std::vector<glm::dmat4> all(matrices.begin(), matrices.begin() + first_);
  for (std::size_t h = 0; h < joints_.size(); ++h) all.push_back(helperMatrix(joints_[h], pose, locals[h]));
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t h = 0; h < joints_.size(); ++h) {
      solveOne(h, pose, all, live, locals[h]);
      all[toIndex(first_) + h] = helperMatrix(joints_[h], pose, locals[h]);
    }
  }
}

// Muscle lines.

namespace {

constexpr double kEven = 1e-4;  ///< Relative unevenness of a scale that does not count.

/// Whether it is a rotation and a uniform scale.
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

/// Middle of the belly on the line, from where the girth grows.
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
