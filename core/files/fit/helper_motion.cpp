// core/files/fit/helper_motion.cpp: one helper after the other, by the points that it has to bring somewhere.
#include "core/files/fit/helper_motion.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/files/fit/rigid_motion.h"
#include "core/geometry/at.h"

namespace sinew::exporting {
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
