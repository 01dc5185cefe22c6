// core/files/fit/helper_motion.cpp: one helper after the other, by the points that it has to bring somewhere.
#include "core/files/fit/helper_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/files/fit/own_eigen.h"
#include "core/geometry/at.h"

namespace sinew::exporting {

// How a helper joint moves what follows it.

namespace {

constexpr double kFlat = 1e-5;  ///< Determinant, beside that of a scale as large in all directions.

}  // namespace

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

// The largest eigenvector of a 4 x 4 matrix is the rotation.

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
  // s(i, k): the sum of (from - mean)[i] * (to - mean)[k].
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

namespace {

/// A helper that nothing asks to move stays; as a share of what its vertices count.
constexpr double kHold = 1e-3;

}  // namespace

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

}  // namespace sinew::exporting
